// Worlds at the limits of what a scene may ask for: a result, or one sentence.
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"

namespace {

using scenes::wall;

}  // namespace

TEST_CASE("App: one cell, a long bar, slivers and splinters are simulated, all numbers finite") {
    const std::pair<const char*, const char*> walls[] = {
        {"[0.1, 0.1, 0.1]", "[1, 1, 1]"},
        {"[400, 0.1, 0.1]", "[4000, 1, 1]"},
        {"[1000, 0.001, 0.001]", "[1, 1, 1]"},
        {"[0.001, 0.001, 0.001]", "[500, 1, 1]"},
    };
    for (const auto& [size, cells] : walls)
        for (const std::string solver : {"cpu", "reference"}) {
            const Workplace place;
            place.write("ok.toml", wall(size, cells));
            const Result result = place.run({"run", "ok.toml", "--solver", solver, "--frames-png",
                                             "0", "--out", "o", "--state", "a.vtu"},
                                            kNoGl);
            INFO(result.command << "\nstderr: " << result.err);
            CHECK(result.exitCode == 0);
            const auto report = place.readJson("o/report.json");
            CHECK(report.at("nan") == 0);
            CHECK(report.at("pieces") == 1);
        }
}

TEST_CASE("App: sizes and numbers of cells that cannot be are one sentence with the field") {
    struct Case {
        std::string size, cells;
        std::vector<std::string> said;
    };
    const std::string good = "[1, 1, 1]";
    std::vector<Case> cases;
    for (const std::string value : {"0", "-1", "1e-30", "1e30", "nan", "-nan", "inf", "-inf"})
        cases.push_back({"[1, " + value + ", 1]", good, {"bad.toml:5:", "size: number 2 must be"}});
    for (const std::string value : {"0", "-1", "1e9", "1e30", "0.5", "nan", "inf", "9e18"})
        cases.push_back(
            {good, "[1, 1, " + value + "]", {"bad.toml:6:", "cells: number 3 must be"}});
    cases.push_back({good, "[16777216, 16777216, 16777216]", {"bad.toml:6:", "too many cells"}});
    for (const Case& c : cases) {
        const Workplace place;
        place.write("bad.toml", wall(c.size, c.cells));
        checkRefused(place.run({"run", "bad.toml"}, kNoGl), 2, c.said);
        CHECK(place.contents() == std::set<std::string>{"bad.toml"});
    }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// Sanitizers would need a minute for it.
TEST_CASE("App: two million tetrahedra are simulated on the CPU, and hang together", "[long]") {
    const Workplace place;
    place.write("large.toml", scenes::kTwoMillion);
    const Result result = place.run(
        {"run", "large.toml", "--solver", "cpu", "--frames-png", "0", "--out", "o"}, kNoGl);
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    const auto report = place.readJson("o/report.json");
    CHECK(report.at("tetrahedra") == 2'000'000);
    CHECK(report.at("nan") == 0);
    CHECK(report.at("pieces") == 1);
}

#if defined(__linux__)
// macOS does not limit addresses; sanitizers take terabytes of them.
TEST_CASE("App: a world beyond the machine's memory is refused at once, and leaves nothing") {
    const Workplace place;
    // As many cells as a world may have.
    place.write("huge.toml", wall("[40.96, 40.96, 0.01]", "[4096, 4096, 1]"));
    for (const std::string solver : {"cpu", "reference", "gather"})
        checkRefused(
            place.runWithMemoryUpTo(8'000'000, {"run", "huge.toml", "--solver", solver}, kNoGl), 2,
            {"the world is too large for this machine's memory: 16777216 cells", "use at most"});
    CHECK(place.contents() == std::set<std::string>{"huge.toml"});
}

TEST_CASE("App: memory that runs out after all is one sentence, too") {
    const Workplace place;
    place.write("large.toml", wall("[50, 20, 0.1]", "[500, 200, 1]"));
    // Between what every solver needs, 115 MB, and what this one does, 240 MB and the program.
    checkRefused(
        place.runWithMemoryUpTo(
            150'000, {"run", "large.toml", "--solver", "reference", "--frames-png", "0"}, kNoGl),
        2, {"not enough memory", "fewer cells"});
    CHECK(place.contents() == std::set<std::string>{"large.toml"});
}
#endif
#endif
