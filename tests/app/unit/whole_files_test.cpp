// Nothing half-written: neither when the program is killed nor when the disk is full.
#include <random>

#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/image.hpp"

#ifndef _WIN32

namespace {

/// 40,000 cells in one step: the state is 50 MB of text, so that writing it takes a while.
const std::string kLarge =
    "frames = 1\n"
    "[solver]\n"
    "substeps = 1\n"
    "[contact]\n"
    "enabled = false\n"
    "[material.soft]\n"
    "young_modulus = 100\n"
    "[[body]]\n"
    "name = 'wall'\n"
    "material = 'soft'\n"
    "size = [10, 8, 0.5]\n"
    "cells = [100, 80, 5]\n";

std::vector<std::string> allFiles() {
    return {"run",   "ok.toml", "--solver", "cpu",    "--frames-png", "0",
            "--out", "o",       "--json",   "a.json", "--state",      "a.vtu"};
}

sunder::image::Image noise(int size, unsigned seed) {
    sunder::image::Image image{size, size, {}};
    std::minstd_rand random(seed);
    for (int i = 0; i < 3 * size * size; ++i)
        image.pixels.push_back(static_cast<std::uint8_t>(random() >> 8));
    return image;
}

}  // namespace

TEST_CASE("App: killed while it writes report and state, it leaves each whole or not at all") {
    std::minstd_rand random(11);
    int killed = 0, unfinished = 0;
    // Eight rounds do where the machine has nothing else to do.
    for (int round = 0; round < 8 || (round < 80 && (killed < 5 || unfinished < 1)); ++round) {
        const Workplace place;
        place.write("ok.toml", kLarge);
        // The state is the last file and the longest: within its writing, or a little before.
        const bool late = round % 4 != 0;
        killed += place.runAndKill(allFiles(), static_cast<int>(random() % 8), late ? "a.tmp" : "");
        for (const std::string& name : place.contents()) {
            INFO(name);
            if (name.ends_with(".json") && !contains(name, ".tmp-"))
                CHECK(nlohmann::json::accept(place.read(name)));
            if (name == "a.vtu") CHECK(place.read(name).ends_with("</VTKFile>\n"));
            unfinished += contains(name, ".tmp-");
        }
    }
    // Else this would have tested nothing.
    CHECK(killed > 4);
    CHECK(unfinished > 0);
}

TEST_CASE("App: on a full disk every file says so by its name, exit code 2, and nothing is left") {
    const Workplace place;
    place.write("ok.toml", kLarge);
    const Result state = place.runWithFilesUpTo(64, allFiles(), kNoGl);  // 32 KiB
    checkRefused(state, 2, {"a.vtu: cannot be written: "});
    // What was whole before stays.
    CHECK(place.contents() == std::set<std::string>{"a.json", "o", "o/report.json", "ok.toml"});

    const Result report = place.runWithFilesUpTo(1, allFiles(), kNoGl);
    checkRefused(report, 2, {"report.json: cannot be written: "});
    CHECK(place.contents() == std::set<std::string>{"a.json", "o", "o/report.json", "ok.toml"});
    CHECK(place.readJson("o/report.json").at("frames") == 1);
}

TEST_CASE("App: compare on a full disk keeps the picture that was there") {
    const Workplace place;
    sunder::image::writePng(place.path("a.png"), noise(40, 1));
    sunder::image::writePng(place.path("b.png"), noise(40, 2));
    place.write("diff.png", "older");
    const Result result =
        place.runWithFilesUpTo(1, {"compare", "a.png", "b.png", "--diff", "diff.png"}, kNoGl);
    CHECK(result.exitCode == 2);
    CHECK(contains(result.err, "sunder: diff.png: cannot be written: "));
    CHECK(place.read("diff.png") == "older");
    CHECK(place.contents() == std::set<std::string>{"a.png", "b.png", "diff.png"});
}

#ifdef __linux__
TEST_CASE("App: a device is written to, not replaced") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    std::vector<std::string> arguments{"run",          "ok.toml", "--solver", "cpu",
                                       "--frames-png", "0",       "--out",    "o"};
    arguments.insert(arguments.end(), {"--json", "/dev/full"});
    checkRefused(place.run(arguments, kNoGl), 2,
                 {"/dev/full: cannot be written: No space left on device"});
    CHECK(std::filesystem::is_character_file("/dev/full"));
    arguments.back() = "/dev/null";
    CHECK(place.run(arguments, kNoGl).exitCode == 0);
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("App: what cannot be said on standard output is exit code 2") {
    const Workplace place;
    for (const std::string command : {"list", "info"}) {
        const Result result = place.run({command}, {}, "/dev/full");
        CHECK(result.exitCode == 2);
        CHECK(contains(result.err, "sunder: standard output cannot be written"));
    }
}
#endif

TEST_CASE("App: a link stays one, and the file it leads to is replaced") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    place.write("real.json", "older");
    std::filesystem::create_symlink("real.json", place.path("link.json"));
    const Result result = place.run({"run", "ok.toml", "--solver", "cpu", "--frames-png", "0",
                                     "--out", "o", "--json", "link.json"},
                                    kNoGl);
    CHECK(result.exitCode == 0);
    CHECK(std::filesystem::is_symlink(place.path("link.json")));
    CHECK(place.readJson("real.json").at("frames") == 5);
}

#endif
