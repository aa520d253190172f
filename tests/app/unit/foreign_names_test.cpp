// Files whose names are not English.
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/image.hpp"

namespace fs = std::filesystem;

namespace {

/// A scene that takes its material from a file beside it, which takes its base from another.
void writeScene(const Workplace& place) {
    fs::create_directories(place.path("日本/木材"));
    place.write("日本/壁 Jürgen.toml",
                "frames = 1\n"
                "[[body]]\n"
                "name = '壁'\n"
                "material = '木材/Grün.toml'\n"
                "size = [0.6, 0.4, 0.1]\n"
                "cells = [6, 4, 1]\n");
    place.write("日本/木材/Grün.toml", "base = './ясень.toml'\n");
    place.write("日本/木材/ясень.toml", "base = 'wood'\ndensity = 450\n");
}

}  // namespace

TEST_CASE("App: scene, material, pictures' folder, state and report may have names in any script") {
    const Workplace place;
    writeScene(place);
    const std::set<std::string> before = place.contents();
    const Result result =
        place.run({"run", "日本/壁 Jürgen.toml", "--solver", "cpu", "--frames-png", "0", "--out",
                   "Ausgänge/出力", "--state", "日本/状態 Jürgen.vtu", "--json", "報告 ü.json"},
                  kNoGl);
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    std::set<std::string> wanted = before;
    wanted.insert({"Ausgänge", "Ausgänge/出力", "Ausgänge/出力/report.json", "日本/状態 Jürgen.vtu",
                   "報告 ü.json"});
    CHECK(place.contents() == wanted);
    CHECK(contains(result.out, "report:   Ausgänge/出力/report.json\n"));
    const nlohmann::json report = place.readJson("報告 ü.json");
    CHECK(report.at("scene") == "壁 Jürgen");
}

TEST_CASE("App: left to itself, a run's folder has the scene's name in any script") {
    const Workplace place;
    place.write("壁 Jürgen.toml", scenes::kFalling);
    const Result result =
        place.run({"run", "壁 Jürgen.toml", "--solver", "reference", "--frames-png", "0"}, kNoGl);
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    CHECK(place.contents() == std::set<std::string>{"out", "out/壁 Jürgen",
                                                    "out/壁 Jürgen/report.json", "壁 Jürgen.toml"});
    CHECK(contains(result.out, "report:   out/壁 Jürgen/report.json\n"));
}

TEST_CASE("App: a complaint has a file's name as it was given") {
    const Workplace place;
    writeScene(place);
    fs::remove(place.path("日本/木材/ясень.toml"));
    const std::vector<std::string> run{"run", "日本/壁 Jürgen.toml", "--solver", "cpu"};
    checkRefused(place.run(run, kNoGl), 2,
                 {"日本/木材/Grün.toml:1: ", "cannot read '日本/木材/./ясень.toml'"});
    place.write("日本/木材/ясень.toml", "density = 'leicht'\n");
    checkRefused(place.run(run, kNoGl), 2, {"日本/木材/./ясень.toml:1: density"});
    checkRefused(place.run({"run", "無い.toml"}, kNoGl), 2, {"cannot read '無い.toml'"});
    place.write("wall.toml", scenes::kFalling);
    for (const char* option : {"--json", "--state", "--video", "--contact-sheet"})
        checkRefused(place.run({"run", "wall.toml", option, "無い/Jürgen.png"}, kNoGl), 2,
                     {"無い/Jürgen.png: cannot be written: there is no folder '無い'"});
    checkRefused(
        place.run({"run", "wall.toml", "--json", "日本/ü.json", "--state", "./日本/ü.json"}, kNoGl),
        2, {"--json and --state both write to './日本/ü.json'"});
    checkRefused(place.run({"view", "--log", "無い/Jürgen.jsonl"}, kNoGl), 2,
                 {"there is no folder '無い'"});
    checkRefused(place.run({"view", "--out", "無い"}, kNoGl), 2, {"無い"});
    checkRefused(place.run({"日本"}, kNoGl), 2, {"there is no command '日本'"});
}

TEST_CASE("App: pictures to compare may have names in any script") {
    const Workplace place;
    sunder::image::writePng(place.path("左.png"), {2, 1, {1, 2, 3, 4, 5, 6}});
    sunder::image::writePng(place.path("Größe.png"), {1, 1, {1, 2, 3}});
    CHECK(place.run({"compare", "左.png", "左.png", "--diff", "違い ü.png", "--json", "é.json"})
              .exitCode == 0);
    CHECK(place.contents() == std::set<std::string>{"Größe.png", "é.json", "左.png", "違い ü.png"});
    const Result differ = place.run({"compare", "左.png", "Größe.png"});
    CHECK(differ.exitCode == 1);
    CHECK(differ.out == "different: 左.png has 2 x 1 pixels, Größe.png has 1 x 1\n");
}
