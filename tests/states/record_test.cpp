// What a record says about the step and the pass in which two runs part.
#include "states/record.hpp"

#include <sstream>

#include "catch.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

const Record kStored = {{0, {{"state", "00"}}},
                        {1, {{"elements", "a1"}, {"contacts", "a1"}, {"nodes", "b1"}}},
                        {2, {{"elements", "a2"}, {"contacts", "a2"}, {"nodes", "b2"}}},
                        {50, {{"state", "50"}}},
                        {100, {{"state", "99"}}}};

std::string difference(std::size_t entry, std::size_t hash, const char* value) {
    Record now = kStored;
    now[entry].hashes[hash].value = value;
    return firstDifference(kStored, now, 50);
}

Record readText(const std::string& text) {
    std::istringstream stream(text);
    return parseRecord(stream, "record.txt");
}

}  // namespace

TEST_CASE("Record: the first step that differs and its first pass are named") {
    CHECK(firstDifference(kStored, kStored, 50).empty());
    CHECK(difference(2, 1, "xx") ==
          "step 2 (of frame 1) is the first that differs, in the pass "
          "`contacts`");
    Record later = kStored;
    for (std::size_t i = 2; i < later.size(); ++i)
        for (RecordEntry::Hash& hash : later[i].hashes) hash.value = "xx";
    CHECK(firstDifference(kStored, later, 50) ==
          "step 2 (of frame 1) is the first that differs, in the pass `elements`");
}

TEST_CASE("Record: what was written to a file is read back, as far as it is kept") {
    const Record written = {
        {0, {{"state", "0123456789abcdef"}}},
        {1, {{"elements", "a1a1a1a1"}, {"nodes", "b1b1b1b1"}}},
        {2, {{"elements", "a1a1ffff"}, {"nodes", "b2b2b2b2"}, {"bonds", "c2c2c2c2"}}},
        {3, {{"elements", "a3a3a3a3"}, {"nodes", "b2b2b2b2"}}},
        {4, {{"elements", "a3a3a3a3"}, {"bonds", "c2c2c2c2"}}}};
    const std::string text =
        "0 state 0123456789abcdef\n"
        "passes elements nodes bonds\n"
        "1 a1a1 b1b1 -\n"
        "2 . b2b2 c2c2\n"
        "3 a3a3 . -\n"
        "4 . - .\n";
    CHECK(toText(written) == text);
    const Record read = readText("# a remark\n" + text);
    CHECK(toText(read) == text);
    CHECK(firstDifference(read, written, 50).empty());
    Record changed = written;
    changed[3].hashes[1].value = "b3b2b2b2";
    CHECK(firstDifference(read, changed, 50) ==
          "step 3 (of frame 1) is the first that differs, in the pass `nodes`");
}

TEST_CASE("Record: a line that is no entry is refused with its number") {
    const std::string columns = "# a remark\npasses elements nodes\n";
    for (const char* line : {"1 a1a1", "1 a1a1 b1b1 c1c1", "one a1a1 b1b1", "1 - -", "1 . b1b1"}) {
        INFO(line);
        CHECK_THROWS_WITH(readText(columns + line + "\n"),
                          Catch::Contains("record.txt:3: must be"));
    }
    for (const char* line : {"1", "1 elements", "1 elements a1a1", "state 0123"}) {
        INFO(line);
        CHECK_THROWS_WITH(readText(std::string(line) + "\n"),
                          Catch::Contains("record.txt:1: must be"));
    }
    CHECK_THROWS_WITH(readRecord("no/such/file.txt"), Catch::Contains("cannot be read"));
}

TEST_CASE("Record: what it cannot know, it says") {
    CHECK(difference(0, 0, "xx") == "the state at the start differs");
    CHECK(difference(4, 0, "xx") ==
          "the state after step 100 (of frame 2) differs; after step 50 all was the same; which "
          "pass it was is not stored for the steps between");
}

TEST_CASE("Record: a pass that runs instead of another is named") {
    Record now = kStored;
    now[1].hashes.erase(now[1].hashes.begin() + 1);
    CHECK(firstDifference(kStored, now, 50) ==
          "step 1 (of frame 1) is the first that differs, in which passes run: the pass `nodes` "
          "instead of the pass `contacts`");
}

// Watched steps take another way through `cpu`, and read back between the passes on a GPU.
TEST_CASE("Record: watching a solver does not change what it computes") {
    for (const bool contact : {false, true}) {
        WorldDescription description = block({5, 3, 2}, brittle());
        description.bodies.push_back(description.bodies[0]);
        description.bodies[1].position = {0, 0.32, 0.02};
        description.gravity = {0, -9.81, 0};
        description.ground = description.contact = contact;
        description.events = {hit(0, {0, 0.15, 0}, {0, 0, -15})};
        const World world(description);
        for (const SolverUnderTest& under : solversUnderTest()) {
            INFO(under.name << (contact ? ", contact" : ""));
            const std::unique_ptr<Solver> watched = under.make(world), alone = under.make(world);
            if (!watched->setPassObserver(nullptr)) continue;
            record(*watched, everyStep(100));
            alone->advance(100);
            const Record end = {{100, {{"state", ""}}}};
            CHECK(toText(record(*watched, end)) == toText(record(*alone, end)));
        }
    }
}
