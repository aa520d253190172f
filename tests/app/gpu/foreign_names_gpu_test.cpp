// What a run draws, in files whose names are not English.
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/image.hpp"

TEST_CASE("App: pictures, contact sheet and video may have names in any script") {
    const Workplace place;
    place.write("壁 Jürgen.toml", scenes::kFalling);
    // A stand-in for ffmpeg, which not every system has: it writes what it is fed.
    const Result result =
        place.run({"run", "壁 Jürgen.toml", "--solver", "cpu", "--frames", "3", "--size", "64x48",
                   "--out", "絵 ö", "--contact-sheet", "一覧 ß.png", "--video", "動画 Jürgen.raw"},
                  {{"PATH", SUNDER_STAND_INS}});
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    CHECK(place.contents() == std::set<std::string>{"一覧 ß.png", "動画 Jürgen.raw",
                                                    "壁 Jürgen.toml", "絵 ö", "絵 ö/frame_0000.png",
                                                    "絵 ö/frame_0003.png", "絵 ö/report.json"});
    CHECK(contains(result.out,
                   "pictures: 絵 ö/frame_*.png\n"
                   "sheet:    一覧 ß.png\n"
                   "video:    動画 Jürgen.raw\n"
                   "report:   絵 ö/report.json\n"));
    CHECK(sunder::image::readPng(place.path("絵 ö/frame_0003.png")).width == 64);
    const std::string video = place.read("動画 Jürgen.raw");
    CHECK(video.size() == 4 * 64 * 48 * 3);
    const sunder::image::Image first = sunder::image::readPng(place.path("絵 ö/frame_0000.png"));
    CHECK(video.starts_with(std::string(first.pixels.begin(), first.pixels.end())));
}
