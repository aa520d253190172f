// Pictures and videos of a run that is killed, or whose disk is full.
#include <cstdlib>
#include <random>

#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/image.hpp"
#include "support/ffmpeg.hpp"

#ifndef _WIN32

TEST_CASE("App: killed while it draws, every picture is whole and there is no video yet") {
    std::vector<std::string> arguments{"run",      "ok.toml", "--solver",     "cpu",
                                       "--frames", "20000",   "--size",       "320x180",
                                       "--out",    "o",       "--frames-png", "1"};
    if (ffmpegIsThere()) arguments.insert(arguments.end(), {"--video", "a.mp4"});
    std::minstd_rand random(5);
    int whole = 0;
    for (int round = 0; round < 4; ++round) {
        const Workplace place;
        place.write("ok.toml", scenes::kFalling);
        REQUIRE(place.runAndKill(arguments, static_cast<int>(random() % 400), "/frame_0001.png"));
        for (const std::string& name : place.contents()) {
            INFO(name);
            CHECK(name != "a.mp4");
            if (!name.ends_with(".png") || contains(name, "/.")) continue;
            CHECK(sunder::image::readPng(place.path(name)).width == 320);
            ++whole;
        }
    }
    CHECK(whole > 4);
}

TEST_CASE("App: on a full disk a picture says so by its name, exit code 2, and is not there") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    const std::vector<std::string> arguments{"run",   "ok.toml", "--solver", "cpu",
                                             "--out", "o",       "--size",   "320x180"};
    checkRefused(place.runWithFilesUpTo(4, arguments), 2, {"frame_0000.png: cannot be written: "});
    CHECK(place.contents() == std::set<std::string>{"ok.toml"});

    std::vector<std::string> sheet = arguments;
    sheet.insert(sheet.end(), {"--frames-png", "0", "--contact-sheet", "s.png"});
    checkRefused(place.runWithFilesUpTo(4, sheet), 2, {"s.png: cannot be written: "});
    CHECK(place.contents() == std::set<std::string>{"ok.toml"});

    if (!ffmpegIsThere()) return;
    std::vector<std::string> video = arguments;
    video.insert(video.end(), {"--frames-png", "0", "--video", "a.mkv"});
    checkRefused(place.runWithFilesUpTo(8, video), 2, {"ffmpeg cannot write 'a.mkv': "});
    CHECK(place.contents() == std::set<std::string>{"ok.toml"});
}

#endif
