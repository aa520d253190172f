// A person at the viewer: a real window, a real mouse, a real keyboard.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>

#include "catch.hpp"
#include "pictures.hpp"
#include "support/ffmpeg.hpp"
#include "viewer_under_test.hpp"

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Pixels of `picture` that are not those of the window at `left`, `top`, leaving out its lowest
/// rows, where a hint is.
double windowDifference(const sunder::image::Image& window, int left, int top,
                        const sunder::image::Image& picture, int rows) {
    std::int64_t wrong = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c)
                wrong += window.pixels[3 * (std::size_t(y + top) * window.width + x + left) + c] !=
                         picture.pixels[3 * (std::size_t(y) * picture.width + x) + c];
    return static_cast<double>(wrong) / (3.0 * picture.width * rows);
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(SUNDER_PRESETS "/scenes"))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

TEST_CASE("Every way of looking at a wall shows something else", "[viewer]") {
    const Screen screen(900, 600);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x600", "--solver", "cpu"});
    viewer.click("pause");
    REQUIRE(viewer.becomes("paused", true));
    viewer.pointAway();  // no ring on the wall
    const sunder::image::Image solid = viewer.keep("10-solid");
    const auto shown = [&](const std::string& widget, const std::string& name) {
        viewer.click(widget);
        viewer.pointAway();
        sunder::image::Image image = viewer.keep(name);
        INFO(widget);
        checkLooksRight(image);
        return image;
    };
    CHECK(sceneDifference(solid, shown("style.Wireframe", "11-wireframe")) > 0.05);
    const sunder::image::Image both = shown("style.Both", "12-both");
    CHECK(sceneDifference(solid, both) > 0.02);
    // At rest both meshes are the same wall; their edges tell them apart.
    CHECK(sceneDifference(both, shown("mesh.Simulation", "13-simulation-mesh")) > 0.02);
    viewer.click("mesh.Display");
    viewer.click("style.Solid");
    CHECK(sceneDifference(solid, shown("samples.4x", "14-samples")) > 0.0005);
    CHECK(viewer.status()["samples"] == 4);
    CHECK(sceneDifference(solid, shown("samples.Off", "15-as-before")) < 0.0005);
    // A screen without a monitor has no pace to keep, so all that shows here is that it was asked
    // for, and that the viewer goes on.
    viewer.click("vsync");
    CHECK(viewer.eventCount("vsync") == 1);

    viewer.key("F1");
    CHECK(sceneDifference(solid, viewer.keep("16-help")) > 0.2);
    viewer.key("F1");
    viewer.click("tab.measure");
    viewer.click("pause");
    const sunder::image::Image plots = viewer.keep("17-measure");
    CHECK(difference(solid, plots, {0, 150, kPanel, 450}) > 0.05);
    screen.act("mousemove 150 450 click --repeat 30 5");
    viewer.place("plot.shadows");
    viewer.keep("18-passes");

    // The camera, by mouse, wheel and keys, and back.
    viewer.click("tab.play");
    viewer.click("pause");
    viewer.pointAt(0.9, 0.15);
    viewer.press(3);
    screen.act("mousemove_relative -- -150 0");
    viewer.freshStatus();
    viewer.release(3);
    const sunder::image::Image turned = viewer.keep("19-turned");
    CHECK(sceneDifference(solid, turned) > 0.1);
    screen.act("click 4 click 4 click 4");
    const sunder::image::Image nearer = viewer.keep("20-nearer");
    CHECK(sceneDifference(turned, nearer) > 0.1);
    viewer.keyDown("w");
    viewer.keyUp("w");
    const sunder::image::Image ahead = viewer.keep("21-ahead");
    CHECK(sceneDifference(nearer, ahead) > 0.1);
    viewer.press(2);
    screen.act("mousemove_relative -- -60 40");
    viewer.freshStatus();
    viewer.release(2);
    CHECK(sceneDifference(ahead, viewer.keep("22-moved-aside")) > 0.1);
    viewer.key("Home");
    viewer.pointAway();
    CHECK(sceneDifference(solid, viewer.keep("23-home")) < 0.0005);
    viewer.quit();
}

TEST_CASE("A picture has the pixels of the window, and those of `sunder run`", "[viewer]") {
    // As wide as the scene's own camera asks for; in a narrower view it is further back.
    const Screen screen(1340, 560);
    ViewerUnderTest viewer(screen, {"glass", "--size", "1340x560", "--solver", "cpu"});
    viewer.key("r");
    viewer.key("space");
    viewer.key("r");
    REQUIRE(viewer.becomes("paused", true));
    screen.act("mousemove 5 550");
    const sunder::image::Image window = viewer.keep("40-glass");
    viewer.key("p");
    const sunder::image::Image picture =
        sunder::image::readPng(viewer.nextEvent("picture", 0)["path"].get<std::string>());
    const Json view = viewer.status()["view"];
    REQUIRE(picture.width == view[2]);
    REQUIRE(picture.height == view[3]);
    CHECK(windowDifference(window, view[0], view[1], picture, picture.height - 60) == 0);

    Child run({SUNDER_PROGRAM, "run", "glass", "--solver", "cpu", "--frames", "1", "--frames-png",
               "1", "--size", std::to_string(picture.width) + "x" + std::to_string(picture.height),
               "--out", (screen.folder() / "out").string()},
              {{"SUNDER_EGL_DEVICE", "software"}}, screen.folder() / "run.txt");
    REQUIRE(run.wait(120) == 0);
    // It draws with four samples.
    viewer.click("samples.4x");
    viewer.key("p");
    const sunder::image::Image sampled =
        sunder::image::readPng(viewer.nextEvent("picture", 1)["path"].get<std::string>());
    const sunder::image::Image written =
        sunder::image::readPng(screen.folder() / "out" / "frame_0000.png");
    CHECK(windowDifference(sampled, 0, 0, written, written.height) == 0);
    viewer.quit();
}

TEST_CASE("A video is recorded while it is asked for", "[viewer]") {
    if (!ffmpegIsThere()) {
        WARN("left out: no ffmpeg");
        return;
    }
    const Screen screen(800, 500);
    ViewerUnderTest viewer(screen, {"--size", "800x500", "--solver", "cpu"});
    viewer.key("v");
    viewer.nextEvent("recording", 0);
    const Json first = viewer.freshStatus();
    const sunder::image::Image image = viewer.keep("65-recording");
    CHECK(share(image, {732, 12, 66, 26}, 240, 240, 235) > 0.01);  // REC
    // Each of its pictures is 1/60 s after the one before.
    const Json last = viewer.freshStatus();
    const double frames = last["frame"].get<double>() - first["frame"].get<double>();
    CHECK(last["time"].get<double>() - first["time"].get<double>() == Approx(frames / 60));
    viewer.key("v");
    const Json video = viewer.nextEvent("video", 0);
    CHECK(video["frames"] >= frames);
    CHECK(fs::file_size(video["path"].get<std::string>()) > 1000);
    viewer.quit();
}

TEST_CASE("A video without ffmpeg is a message that names it", "[viewer]") {
    const Screen screen(800, 500);
    fs::create_directory(screen.folder() / "empty");
    ViewerUnderTest viewer(screen, {"--size", "800x500", "--solver", "cpu"},
                           {{"PATH", (screen.folder() / "empty").string()}});
    viewer.key("v");
    CHECK_THAT(viewer.nextEvent("problem", 0)["text"].get<std::string>(),
               Catch::Contains("ffmpeg") && Catch::Contains("not installed"));
    viewer.keep("67-no-ffmpeg");
    CHECK(viewer.eventCount("recording") == 0);
    const Json now = viewer.freshStatus();
    CHECK(eventually([&] { return viewer.status()["time"] > now["time"]; }));
    viewer.quit();
}

TEST_CASE("Every scene can be opened from the list", "[viewer]") {
    const Screen screen(900, 640);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x640", "--solver", "cpu"});
    viewer.click("tab.wall");
    for (const std::string& name : sceneNames()) {
        INFO(name);
        viewer.click("scene");
        viewer.click("scene." + name);
        REQUIRE(viewer.becomes("scene", name));
        checkLooksRight(viewer.keep("70-scene-" + name));
        CHECK(viewer.status()["nan"] == 0);
    }
    viewer.quit();
}

TEST_CASE("Clicks and keys at random do no harm", "[viewer]") {
    std::mt19937 random(20240607);
    const auto below = [&](std::size_t count) { return static_cast<int>(random() % count); };
    const std::vector<std::string> keys{
        "space", "period", "comma", "bracketleft", "bracketright", "r",    "n",    "t", "m",
        "l",     "c",      "p",     "h",           "F1",           "Home", "Tab",  "1", "5",
        "9",     "g",      "v",     "Escape",      "F11",          "F12",  "a",    "w", "e",
        "Left",  "Up",     "Right", "Down",        "Return",       "0",    "minus"};
    const std::array<std::string, 6> held{"", "", "", "shift", "ctrl", "alt"};
    for (const std::string solver : {"cpu", "gather"}) {
        const Screen screen(1100, 700);
        ViewerUnderTest viewer(screen, {"wood", "--size", "1100x700", "--solver", solver});
        for (int action = 0; action < 40; ++action) {
            const std::string with = held[below(held.size())];
            const auto holding = [&](const std::string& act) {
                return with.empty() ? act : "keydown " + with + " " + act + " keyup " + with;
            };
            const std::string at =
                "mousemove " + std::to_string(below(1100)) + " " + std::to_string(below(700)) + " ";
            const int what = below(20);
            if (what == 0)
                screen.act("search --name '^Sunder$' windowsize " +
                           std::to_string(340 + below(760)) + " " +
                           std::to_string(240 + below(460)));
            else if (what < 6)
                screen.act("key " + keys[below(keys.size())]);
            else if (what < 10)
                screen.act(at + holding("mousedown 1 mousemove_relative -- " +
                                        std::to_string(below(200) - 100) + " 30 mouseup 1"));
            else  // the wheel's turns are buttons, too
                screen.act(at + holding("click " + std::to_string(below(5) + 1)));
            INFO("action " << action << "\n" << viewer.output());
            REQUIRE(viewer.running());
            sleepFor(0.05);
        }
        // What may have been left open: a text field, a list, a video.
        viewer.key("Escape");
        viewer.keep("80-random-" + solver);
        CHECK(viewer.status()["nan"] == 0);
        viewer.quit();
    }
}
