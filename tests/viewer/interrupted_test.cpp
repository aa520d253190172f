// A viewer that is asked to end by a signal, and what it saves beside others.
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>

#include "catch.hpp"
#include "image/image.hpp"
#include "support/ffmpeg.hpp"
#include "viewer_under_test.hpp"

namespace fs = std::filesystem;

namespace {

/// Videos and their beginnings.
std::set<std::string> videosIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".mp4") names.insert(entry.path().filename().string());
    return names;
}

/// One that is well at the first call, which is the trial, and never ends after that.
std::string endlessFfmpeg(const fs::path& folder) {
    fs::create_directory(folder / "bin");
    const fs::path program = folder / "bin" / "ffmpeg";
    std::ofstream(program) << "#!/bin/sh\n"
                              "for last; do :; done\n"
                              "echo half > \"${last#file:}\"\n"
                              "cd '"
                           << folder.string()
                           << "'\n"
                              "cat > /dev/null\n"
                              "[ -e tried ] || { : > tried; exit; }\n"
                              ": > finishing\n"
                              "exec sleep 1000\n";
    fs::permissions(program, fs::perms::owner_all);
    return (folder / "bin").string() + ":/usr/bin:/bin";
}

}  // namespace

TEST_CASE("A viewer that is interrupted finishes its video and keeps its settings", "[viewer]") {
    if (!ffmpegIsThere()) {
        WARN("left out: no ffmpeg");
        return;
    }
    const Screen screen(800, 500);
    ViewerUnderTest viewer(screen, {"--size", "800x500", "--solver", "cpu"});
    viewer.key("t");
    viewer.key("v");
    viewer.nextEvent("recording", 0);
    viewer.freshStatus();
    viewer.send(SIGINT);
    viewer.endsSoundly(130);
    CHECK(videosIn(screen.folder()) == std::set<std::string>{"wood-001.mp4"});
    CHECK(fs::file_size(screen.folder() / "wood-001.mp4") > 1000);
    CHECK_THAT(viewer.output(), Catch::StartsWith("sunder: interrupted: Video saved: ") &&
                                    Catch::EndsWith("wood-001.mp4\n"));
    CHECK_THAT(textOf(viewer.settings()), Catch::Contains("\ntool = \"push\"\n"));
}

TEST_CASE("A second signal gives up a video that takes its time", "[viewer]") {
    const Screen screen(800, 500);
    ViewerUnderTest viewer(screen, {"--size", "800x500", "--solver", "cpu"},
                           {{"PATH", endlessFfmpeg(screen.folder())}});
    viewer.key("t");
    viewer.key("v");
    viewer.nextEvent("recording", 0);
    viewer.freshStatus();
    viewer.send(SIGTERM);
    REQUIRE(eventually([&] { return fs::exists(screen.folder() / "finishing"); }));
    REQUIRE(viewer.running());
    viewer.send(SIGTERM);
    viewer.endsSoundly(143);
    CHECK(videosIn(screen.folder()).empty());
    CHECK(viewer.output() == "sunder: interrupted: The video was given up\n");
    CHECK_THAT(textOf(viewer.settings()), Catch::Contains("\ntool = \"push\"\n"));
}

TEST_CASE("A viewer that is interrupted while it shows a wall keeps its settings", "[viewer]") {
    const Screen screen(800, 500);
    ViewerUnderTest viewer(screen, {"--size", "800x500", "--solver", "cpu"});
    viewer.key("space");  // also where it waits for what the user does
    viewer.key("t");
    viewer.send(SIGTERM);
    viewer.endsSoundly(143);
    CHECK(viewer.output() == "sunder: interrupted\n");
    CHECK_THAT(textOf(viewer.settings()), Catch::Contains("\ntool = \"push\"\n"));
}

TEST_CASE("What another saves meanwhile is not lost", "[viewer]") {
    if (!ffmpegIsThere()) {
        WARN("left out: no ffmpeg");
        return;
    }
    const Screen screen(800, 500);
    ViewerUnderTest viewer(screen, {"--size", "800x500", "--solver", "cpu"});
    viewer.key("v");
    viewer.nextEvent("recording", 0);
    viewer.freshStatus();
    std::ofstream(screen.folder() / "wood-001.mp4") << "another's";
    std::ofstream(screen.folder() / "wood-001.png") << "another's";
    viewer.key("v");
    CHECK_THAT(viewer.nextEvent("video", 0)["path"].get<std::string>(),
               Catch::EndsWith("wood-002.mp4"));
    viewer.key("p");
    CHECK_THAT(viewer.nextEvent("picture", 0)["path"].get<std::string>(),
               Catch::EndsWith("wood-002.png"));
    CHECK(sunder::image::readPng(screen.folder() / "wood-002.png").height == 500);
    CHECK(textOf(screen.folder() / "wood-001.mp4") == "another's");
    CHECK(textOf(screen.folder() / "wood-001.png") == "another's");
    CHECK(videosIn(screen.folder()) == std::set<std::string>{"wood-001.mp4", "wood-002.mp4"});
    viewer.quit();
}
