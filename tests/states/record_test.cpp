// What a record says about the step and the pass in which two runs part.
#include "states/record.hpp"
#include "catch.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;

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
            planRecord(world, *watched, 2, 50);
            alone->advance(100);
            const Record end = {{100, {{"state", ""}}}};
            CHECK(toText(record(*watched, end)) == toText(record(*alone, end)));
        }
    }
}
