// Videos and pictures of a run that is asked to end by a signal.
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/image.hpp"
#include "support/ffmpeg.hpp"

#ifndef _WIN32

#include <csignal>
#include <cstdlib>
#include <random>

namespace {

namespace fs = std::filesystem;

/// Goes on until somebody ends it.
std::vector<std::string> endless(const std::vector<std::string>& more) {
    std::vector<std::string> all{"run",     "ok.toml", "--solver", "cpu",   "--frames",
                                 "1000000", "--size",  "160x90",   "--out", "o"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Files that were being made.
bool hasLeftovers(const Workplace& place) {
    for (const std::string& name : place.contents())
        if (contains(name, ".tmp-")) return true;
    return false;
}

/// One that is well at the first call, which is the trial, leaves its process' number at the
/// second, and then does what `script` says.
Workplace::Environment withFfmpeg(const Workplace& place, const std::string& script) {
    fs::create_directory(place.path("bin"));
    place.write("bin/ffmpeg", R"(#!/bin/sh
for last; do :; done
echo half > "${last#file:}"
if [ ! -e tried ]; then
    : > tried
    exec cat > /dev/null
fi
echo $$ > number.new
mv number.new number
)" + script);
    fs::permissions(place.path("bin/ffmpeg"), fs::perms::owner_all);
    return {{"PATH", place.path("bin").string() + ":/usr/bin:/bin"}};
}

/// Whether the process whose number it left has gone.
bool ffmpegHasGone(const Workplace& place) {
    const int process = std::stoi(place.read("number"));
    return eventually([&] { return kill(process, 0) != 0; });
}

}  // namespace

TEST_CASE("App: a video that is interrupted is finished with the pictures it has") {
    if (!ffmpegIsThere()) {
        WARN("left out: ffmpeg and ffprobe are not installed");
        return;
    }
    for (const int signal : {SIGINT, SIGTERM}) {
        const Workplace place;
        place.write("ok.toml", scenes::kFalling);
        RunningProgram program = place.start(endless({"--frames-png", "1", "--video", "a.mp4"}));
        REQUIRE(eventually([&] { return fs::exists(place.path("o/frame_0002.png")); }));
        program.sendAll(signal);
        const Result result = program.wait();
        checkRefused(result, 128 + signal, {"the video 'a.mp4' ends there, there is no report"});
        CHECK_FALSE(hasLeftovers(place));
        REQUIRE(place.contents().count("a.mp4") == 1);
        const int frames = std::stoi(result.err.substr(result.err.find("after ") + 6));
        CHECK(frames > 1);
        const std::string count =
            "[ $(ffprobe -v error -count_frames -show_entries "
            "stream=nb_read_frames -of csv=p=0 '" +
            place.path("a.mp4").string() + "') = " + std::to_string(frames) + " ]";
        CHECK(std::system(count.c_str()) == 0);
    }
}

TEST_CASE("App: a second signal gives up a video that takes its time, and nothing is left") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    place.write("a.mp4", "mine");
    const Workplace::Environment environment =
        withFfmpeg(place, "cat > /dev/null\n: > finishing\nsleep 1000\n");
    RunningProgram program =
        place.start(endless({"--frames-png", "0", "--video", "a.mp4"}), environment);
    REQUIRE(eventually([&] { return fs::exists(place.path("number")); }));
    program.sendAll(SIGTERM);
    REQUIRE(eventually([&] { return fs::exists(place.path("finishing")); }));
    REQUIRE(program.running());
    program.sendAll(SIGINT);
    checkRefused(program.wait(), 143, {"the video 'a.mp4' was given up, there is no report"});
    CHECK(ffmpegHasGone(place));
    CHECK(place.contents() == std::set<std::string>{"a.mp4", "bin", "bin/ffmpeg", "finishing",
                                                    "number", "ok.toml", "tried"});
    CHECK(place.read("a.mp4") == "mine");
}

TEST_CASE("App: an ffmpeg that no longer reads does not keep a run from ending") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    const Workplace::Environment environment = withFfmpeg(place, "exec sleep 1000\n");
    RunningProgram program =
        place.start(endless({"--frames-png", "0", "--video", "a.mp4"}), environment);
    REQUIRE(eventually([&] { return fs::exists(place.path("number")); }));
    // Two of a kind may count as one where the first has not arrived yet.
    REQUIRE(eventually([&] {
        program.sendAll(SIGINT);
        return !program.running();
    }));
    checkRefused(program.wait(), 130, {"the video 'a.mp4' was given up"});
    CHECK(ffmpegHasGone(place));
    CHECK_FALSE(hasLeftovers(place));
    CHECK_FALSE(fs::exists(place.path("a.mp4")));
}

TEST_CASE("App: a signal that ends ffmpeg as well leaves no video, and that is said") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    // It reads a little and then waits, so that it is fed when the signals come.
    const Workplace::Environment environment = withFfmpeg(place, "exec sleep 1000\n");
    RunningProgram program =
        place.start(endless({"--frames-png", "0", "--video", "a.mp4"}), environment);
    REQUIRE(eventually([&] { return fs::exists(place.path("number")); }));
    program.sendAll(SIGTERM);
    kill(std::stoi(place.read("number")), SIGTERM);
    checkRefused(program.wait(), 143,
                 {"ffmpeg cannot write 'a.mp4': ", "the video 'a.mp4' was given up"});
    CHECK_FALSE(hasLeftovers(place));
    CHECK_FALSE(fs::exists(place.path("a.mp4")));
}

TEST_CASE("App: interrupted while it draws, every picture is whole and nothing else is there") {
    std::minstd_rand random(5);
    for (int round = 0; round < 4; ++round) {
        const Workplace place;
        place.write("ok.toml", scenes::kFalling);
        RunningProgram program =
            place.start(endless({"--frames-png", "1", "--contact-sheet", "sheet.png"}));
        REQUIRE(eventually([&] { return fs::exists(place.path("o/frame_0001.png")); }));
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 100));
        const int signal = round % 2 ? SIGINT : SIGTERM;
        program.sendAll(signal);
        if (round > 1) program.sendAll(signal);
        checkRefused(program.wait(), 128 + signal,
                     {"there is no contact sheet, there is no report"});
        int pictures = 0;
        for (const std::string& name : place.contents()) {
            INFO(name);
            CHECK((name == "o" || name == "ok.toml" || name.ends_with(".png")));
            if (!name.ends_with(".png")) continue;
            CHECK(sunder::image::readPng(place.path(name)).width == 160);
            ++pictures;
        }
        CHECK(pictures > 1);
        CHECK_FALSE(hasLeftovers(place));
    }
}

#endif
