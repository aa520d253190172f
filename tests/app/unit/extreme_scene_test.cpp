// Worlds at the limits of what a scene may ask for: a result, or one sentence.
#include "app/support/program.hpp"
#include "catch.hpp"

namespace {

std::string wall(const std::string& size, const std::string& cells) {
    return "frames = 1\n[[body]]\nname = 'wall'\nmaterial = 'rubber'\nsize = " + size +
           "\ncells = " + cells + "\n";
}

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
