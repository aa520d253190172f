// Videos and contact sheets of runs.
#include <cstdlib>
#include <set>
#include <string>

#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/contact_sheet.hpp"
#include "image/image.hpp"
#include "image/scaling.hpp"
#include "support/ffmpeg.hpp"

using sunder::image::Image;

namespace {

std::vector<std::string> arguments(const std::vector<std::string>& more,
                                   const std::string& size = "320x180") {
    std::vector<std::string> all{"run",   "wall.toml", "--solver", "cpu",
                                 "--out", "o",         "--size",   size};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

void runWell(const Workplace& place, const std::vector<std::string>& more,
             const std::string& size = "320x180") {
    const Result result = place.run(arguments(more, size));
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
}

Image framePng(const Workplace& place, int frame) {
    char name[32];
    std::snprintf(name, sizeof name, "o/frame_%04d.png", frame);
    return sunder::image::readPng(place.path(name));
}

/// What a sheet of these frames must be, made from the pictures of the run.
Image expectedSheet(const Workplace& place,
                    const std::vector<std::pair<int, std::string>>& frames) {
    const Image first = framePng(place, frames.front().first);
    const sunder::image::SheetLayout layout(static_cast<int>(frames.size()), first.width,
                                            first.height);
    sunder::image::ContactSheet sheet(layout);
    for (const auto& [frame, time] : frames)
        sheet.add(
            sunder::image::scaledDown(framePng(place, frame), layout.tileWidth, layout.tileHeight),
            time);
    return sheet.image();
}

#ifndef _WIN32

/// `name` is a shell script in the folder bin.
Workplace::Environment withProgram(const Workplace& place, const std::string& name,
                                   const std::string& script) {
    namespace fs = std::filesystem;
    fs::create_directory(place.path("bin"));
    place.write("bin/" + name, "#!/bin/sh\n" + script);
    fs::permissions(place.path("bin/" + name), fs::perms::owner_all);
    return {{"PATH", place.path("bin").string() + ":/usr/bin:/bin"}};
}

std::string outputOf(const Workplace& place, const std::string& command) {
    const std::string file = place.path("output.txt").string();
    INFO(command);
    REQUIRE(std::system((command + " > '" + file + "'").c_str()) == 0);
    const std::string text = place.read("output.txt");
    std::filesystem::remove(file);
    return text;
}

#endif

}  // namespace

TEST_CASE("App: a contact sheet has the frames that were asked for, each with its time") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    runWell(place, {"--frames", "30", "--frames-png", "1", "--contact-sheet", "sheet.png",
                    "--sheet-times", "0.5,0,0.049,0.05,0.21"});
    const Image sheet = sunder::image::readPng(place.path("sheet.png"));
    const Image expected = expectedSheet(
        place, {{0, "0.00 s"}, {3, "0.05 s"}, {13, "0.22 s"}, {30, "0.50 s"}});  // 13/60 = 0.2167
    CHECK(sheet.width == 4 * 320 + 3 * sunder::image::SheetLayout::kGap);
    CHECK(sheet.pixels == expected.pixels);
}

TEST_CASE("App: left to itself, a contact sheet begins with the first event") {
    const Workplace place;
    std::string scene = scenes::kBreaking;
    scene.replace(scene.find("time = 0\n"), 9, "time = 0.1\n");
    place.write("wall.toml", scene);
    runWell(place, {"--frames", "50", "--frames-png", "1", "--contact-sheet", "sheet.png"});
    // From frame 6 on, 44 more in the squares of elevenths, but at least one frame each.
    CHECK(sunder::image::readPng(place.path("sheet.png")).pixels ==
          expectedSheet(place, {{6, "0.10 s"},
                                {7, "0.12 s"},
                                {8, "0.13 s"},
                                {9, "0.15 s"},
                                {12, "0.20 s"},
                                {15, "0.25 s"},
                                {19, "0.32 s"},
                                {24, "0.40 s"},
                                {29, "0.48 s"},
                                {35, "0.58 s"},
                                {42, "0.70 s"},
                                {50, "0.83 s"}})
              .pixels);
}

TEST_CASE("App: without an event a contact sheet is spread evenly over the run") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    runWell(place, {"--frames", "22", "--fps", "200", "--frames-png", "1", "--contact-sheet",
                    "sheet.png"});
    std::vector<std::pair<int, std::string>> frames;
    for (int hundredth = 0; hundredth <= 11; ++hundredth)
        frames.push_back({2 * hundredth, hundredth < 10
                                             ? "0.0" + std::to_string(hundredth) + "0 s"
                                             : "0.1" + std::to_string(hundredth - 10) + "0 s"});
    CHECK(sunder::image::readPng(place.path("sheet.png")).pixels ==
          expectedSheet(place, frames).pixels);
}

TEST_CASE("App: a run of few frames has each of them on its sheet once, and no other pictures") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    runWell(place, {"--frames", "2", "--frames-png", "0", "--contact-sheet", "o/sheet.png"});
    CHECK(place.contents() ==
          std::set<std::string>{"o", "o/report.json", "o/sheet.png", "wall.toml"});
    CHECK(sunder::image::readPng(place.path("o/sheet.png")).width ==
          3 * 320 + 2 * sunder::image::SheetLayout::kGap);
}

TEST_CASE("App: --colour changes walls and adds a legend") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    std::set<std::string> pictures;
    for (const std::string colour : {"material", "stress", "speed", "piece"}) {
        runWell(place, {"--colour", colour, "--frames", "3", "--frames-png", "3"});
        const Image image = framePng(place, 3);
        pictures.emplace(image.pixels.begin(), image.pixels.end());
    }
    CHECK(pictures.size() == 4);
}

#ifndef _WIN32

TEST_CASE("App: a video that fails on the way leaves nothing, and what was there before") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    place.write("wall.mp4", "mine");
    // Well at the first call, which is the trial; then it stops in the middle of a frame.
    const Workplace::Environment environment = withProgram(place, "ffmpeg", R"(
for last; do :; done
echo half > "${last#file:}"
if [ -e tried ]; then
    head -c 100 > /dev/null
    echo "[mp4 @ 0x5581] $last: No space left on device" >&2
    echo "Conversion failed!" >&2
    exit 1
fi
: > tried
cat > /dev/null
)");
    const Result result =
        place.run(arguments({"--frames-png", "0", "--video", "wall.mp4"}), environment);
    INFO(result.err);
    CHECK(result.exitCode == 2);
    CHECK(contains(result.err,
                   "sunder: ffmpeg cannot write 'wall.mp4': wall.mp4: No space left on "
                   "device\n"));
    CHECK(place.contents() ==
          std::set<std::string>{"bin", "bin/ffmpeg", "tried", "wall.mp4", "wall.toml"});
    CHECK(place.read("wall.mp4") == "mine");
}

TEST_CASE("App: an ffmpeg that takes all and then fails is believed") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    const Workplace::Environment environment = withProgram(place, "ffmpeg", R"(
for last; do :; done
echo half > "${last#file:}"
cat > /dev/null
[ ! -e tried ] || exit 1
: > tried
)");
    const Result result =
        place.run(arguments({"--frames-png", "0", "--video", "wall.mp4"}), environment);
    CHECK(result.exitCode == 2);
    CHECK(contains(result.err, "ffmpeg cannot write 'wall.mp4': it ended without a word\n"));
    CHECK(place.contents() == std::set<std::string>{"bin", "bin/ffmpeg", "tried", "wall.toml"});
}

TEST_CASE("App: a video has every frame of the run, and their colours") {
    if (!ffmpegIsThere()) {
        WARN("left out: ffmpeg and ffprobe are not installed");
        return;
    }
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const std::string name = "-a 'wall' $(touch harm) \"%d\".mp4";  // no shell, no option
    runWell(place, {"--frames", "7", "--fps", "30", "--frames-png", "7", "--video=" + name});
    CHECK(place.contents() == std::set<std::string>{name, "o", "o/frame_0000.png",
                                                    "o/frame_0007.png", "o/report.json",
                                                    "wall.toml"});
    std::filesystem::rename(place.path(name), place.path("wall.mp4"));
    const std::string file = "'" + place.path("wall.mp4").string() + "'";
    CHECK(outputOf(place,
                   "ffprobe -v error -count_frames -show_entries "
                   "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames -of "
                   "csv=p=0 " +
                       file) == "h264,320,180,yuv420p,30/1,8\n");

    // Frame 7 as a player shows it.
    outputOf(place, "ffmpeg -v error -i " + file + " -vf select=eq\\(n\\\\,7\\) -frames:v 1 '" +
                        place.path("seven.png").string() + "'");
    const Image shown = sunder::image::readPng(place.path("seven.png")), drawn = framePng(place, 7);
    REQUIRE(shown.pixels.size() == drawn.pixels.size());
    double sum = 0;
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i)
        sum += std::abs(int{shown.pixels[i]} - int{drawn.pixels[i]});
    CHECK(sum / static_cast<double>(drawn.pixels.size()) < 3);
}

TEST_CASE("App: ffmpeg's own refusals come before the run") {
    if (!ffmpegIsThere()) {
        WARN("left out: ffmpeg and ffprobe are not installed");
        return;
    }
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    for (const std::string name : {"wall.foo", "wall", "wall.png"}) {
        checkRefused(place.run(arguments({"--video", name})), 2,
                     {"ffmpeg cannot write '" + name + "': "});
        CHECK(place.contents() == std::set<std::string>{"wall.toml"});
    }
    // H.264 takes even sizes only; the video has a line more.
    runWell(place, {"--frames-png", "0", "--video", "odd.mkv"}, "33x17");
    CHECK(outputOf(place, "ffprobe -v error -show_entries stream=width,height -of csv=p=0 '" +
                              place.path("odd.mkv").string() + "'") == "34,18\n");
}

#endif
