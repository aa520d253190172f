#include <algorithm>
#include <filesystem>
#include <sstream>

#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"

namespace {

/// The lines under `heading`, up to the next heading.
std::string section(const std::string& text, const std::string& heading) {
    std::istringstream lines(text);
    std::string found;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(' ', 0) != 0)
            inside = line == heading;
        else if (inside)
            found += line + '\n';
    }
    return found;
}

}  // namespace

TEST_CASE("App: --help names every command, and a command's --help its options") {
    const Workplace place;
    const Result program = place.run({"--help"}, kNoGl);
    CHECK(program.exitCode == 0);
    CHECK(program.err.empty());
    for (const std::string command : {"run", "bench", "info", "list"}) {
        INFO(command);
        CHECK(contains(program.out, "\n  " + command + " "));
        const Result one = place.run({command, "--help"}, kNoGl);
        CHECK(one.exitCode == 0);
        CHECK(one.err.empty());
        CHECK(contains(one.out, "Usage: sunder " + command));
    }
    const Result run = place.run({"run", "--help"}, kNoGl);
    for (const std::string option :
         {"--solver", "--frames", "--fps", "--seed", "--size", "--out", "--frames-png", "--video",
          "--contact-sheet", "--sheet-times", "--style", "--colour", "--state", "--json"}) {
        INFO(option);
        CHECK(contains(run.out, "  " + option + " "));
    }
    CHECK(place.contents().empty());
}

TEST_CASE("App: list names every preset that is in the source folder, and every solver") {
    const Workplace place;
    const Result result = place.run({"list"}, kNoGl);
    CHECK(result.exitCode == 0);
    CHECK(result.err.empty());
    for (const auto& [heading, folder] :
         {std::pair{"Scenes", "scenes"}, std::pair{"Materials", "materials"}}) {
        const std::string listed = section(result.out, heading);
        int count = 0;
        for (const auto& file :
             std::filesystem::directory_iterator(std::filesystem::path(SUNDER_PRESETS) / folder)) {
            INFO(file.path().string());
            CHECK(contains(listed, "  " + file.path().stem().string() + " "));
            ++count;
        }
        CHECK(count > 0);
        CHECK(std::count(listed.begin(), listed.end(), '\n') == count);
    }
    const std::string solvers = section(result.out, "Solvers");
    for (const std::string solver : {"scatter", "gather", "cpu", "reference"}) {
        INFO(solver);
        CHECK(contains(solvers, "  " + solver + " "));
    }
}

TEST_CASE("App: a wrong command line is one sentence and exit code 2, and leaves nothing") {
    struct Case {
        std::vector<std::string> arguments;
        std::vector<std::string> said;
    };
    const std::vector<Case> cases{
        {{}, {"required", "(see: sunder --help)"}},
        {{"rum"}, {"there is no command 'rum'", "run", "info", "list"}},
        {{"run"}, {"scene is required", "(see: sunder run --help)"}},
        {{"run", "ok.toml", "more"}, {"more"}},
        {{"run", "ok.toml", "--sovler", "scatter"}, {"--sovler"}},
        {{"run", "ok.toml", "--size", "big"}, {"--size", "'big'", "1280x720"}},
        {{"run", "ok.toml", "--size", "160x"}, {"--size", "'160x'"}},
        {{"run", "ok.toml", "--size", "160x90x"}, {"--size", "'160x90x'"}},
        {{"run", "ok.toml", "--size", "-160x90"}, {"--size"}},
        {{"run", "ok.toml", "--size", "8x8"}, {"--size", "16 to 8192"}},
        {{"run", "ok.toml", "--size", "4294967456x90"}, {"--size"}},  // 2^32 + 160
        {{"run", "ok.toml", "--frames", "0"}, {"--frames", "1 to 1000000"}},
        {{"run", "ok.toml", "--frames", "five"}, {"--frames", "five"}},
        {{"run", "ok.toml", "--frames"}, {"--frames"}},
        {{"run", "ok.toml", "--fps", "0"}, {"--fps", "1 to 1000"}},
        {{"run", "ok.toml", "--fps", "nan"}, {"--fps"}},
        {{"run", "ok.toml", "--seed", "-1"}, {"--seed", "whole number"}},
        {{"run", "ok.toml", "--seed", "18446744073709551616"}, {"--seed"}},  // 2^64
        {{"run", "ok.toml", "--frames-png", "-1"}, {"--frames-png"}},
        {{"run", "ok.toml", "--style", "cubist"}, {"--style", "wireframe"}},
        {{"run", "ok.toml", "--solver", "magic"}, {"'magic'", "scatter", "gather", "reference"}},
        {{"run", "ok.toml", "--json", "none/a.json"}, {"none/a.json", "no folder 'none'"}},
        {{"run", "ok.toml", "--state", "none/a.vtu"}, {"none/a.vtu", "no folder 'none'"}},
        {{"run", "ok.toml", "--json", "."}, {"it is a folder"}},
        {{"list", "wood"}, {"wood"}},
    };
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    for (const Case& c : cases) {
        const Result result = place.run(c.arguments, kNoGl);
        checkRefused(result, 2, c.said);
        CHECK(place.contents() == std::set<std::string>{"ok.toml"});
    }
}
