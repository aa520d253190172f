// The window around it all: its size, its focus, its end, and what it is the next time.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include "catch.hpp"
#include "pictures.hpp"
#include "viewer_under_test.hpp"

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string kFind = "search --name '^Sunder$' ";

}  // namespace

TEST_CASE("Windows that change size, hide or fill the screen do no harm", "[viewer]") {
    const Screen screen(1400, 900);
    ViewerUnderTest viewer(screen, {"brick", "--size", "1000x600", "--solver", "cpu"});
    for (const auto& [width, height] :
         {std::pair{1300, 800}, {500, 300}, {340, 240}, {1280, 720}}) {
        screen.act(kFind + "windowsize " + std::to_string(width) + " " + std::to_string(height));
        CHECK(viewer.becomes("window", Json::array({width, height})));
        viewer.clickScene(0.5, 0.5);
    }
    screen.act(kFind + "windowunmap");
    sleepFor(0.5);
    screen.act(kFind + "windowmap");
    viewer.freshStatus();
    screen.act(kFind + "windowfocus");
    viewer.key("F11");
    CHECK(viewer.becomes("full_screen", true));
    CHECK(viewer.becomes("window", Json::array({1400, 900})));
    checkLooksRight(viewer.keep("50-full-screen"));
    viewer.key("Escape");
    CHECK(viewer.becomes("full_screen", false));
    CHECK(viewer.becomes("window", Json::array({1280, 720})));
    screen.act(kFind + "windowfocus");  // as a window manager does
    viewer.key("Tab");
    CHECK(viewer.status()["view"][0] == 0);
    viewer.key("Tab");
    CHECK(viewer.status()["view"][0] == kPanel);
    viewer.quit();
}

TEST_CASE("What has not changed is not drawn again", "[viewer]") {
    const Screen screen(900, 560);
    for (const std::string solver : {"cpu", "gather"}) {
        INFO(solver);
        ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", solver});
        const auto pictures = [&] { return viewer.freshStatus()["pictures"].get<int>(); };
        const auto frame = [&] { return viewer.status()["frame"].get<int>(); };
        viewer.pointAway();
        // Time runs, and the wall falls asleep.
        int drawn = pictures();
        REQUIRE(eventually([&] { return drawn == std::exchange(drawn, pictures()); }));
        const sunder::image::Image standing = viewer.keep("59-asleep-" + solver);
        const int before = frame();
        REQUIRE(eventually([&] { return frame() > before + 10; }));
        CHECK(pictures() == drawn);

        viewer.keyDown("Right");
        viewer.keyUp("Right");
        CHECK(pictures() > drawn);
        CHECK(sceneDifference(standing, viewer.keep("59-turned-" + solver)) > 0.02);
        drawn = pictures();
        viewer.clickScene(0.5, 0.5);
        viewer.pointAway();
        CHECK(pictures() > drawn + 1);
        REQUIRE(eventually([&] { return viewer.status()["bonds_broken"] > 0; }));
        viewer.key("space");
        REQUIRE(viewer.becomes("paused", true));
        // Nor is it where time stands still, whatever is in the air.
        drawn = pictures();
        CHECK(pictures() == drawn);
        // What is shown is what would be drawn: another mesh, and this one again.
        const sunder::image::Image stopped = viewer.keep("59-stopped-" + solver);
        viewer.key("m");
        CHECK(pictures() > drawn);
        viewer.key("m");
        CHECK(sceneDifference(stopped, viewer.keep("59-drawn-again-" + solver)) == 0);
        viewer.quit();
    }
}

TEST_CASE("Keys that are held are let go with the focus", "[viewer]") {
    const Screen screen(1000, 600);
    ViewerUnderTest viewer(screen, {"brick", "--size", "900x560", "--solver", "cpu"});
    screen.act(kFind + "windowfocus");
    viewer.key("space");
    REQUIRE(viewer.becomes("focused", true));
    viewer.pointAway();
    // Beside the window: what has no focus and lies under the mouse would hear of keys.
    screen.act("mousemove 990 590");
    const sunder::image::Image start = viewer.keep("51-before-a-key-is-held");
    viewer.keyDown("Right");
    const sunder::image::Image turned = viewer.keep("52-while-a-key-is-held");
    CHECK(sceneDifference(start, turned) > 0.05);

    // Its release is never heard of.
    screen.act("search --maxdepth 0 --name '' windowfocus");
    REQUIRE(viewer.becomes("focused", false));
    screen.act("keyup Right");
    const sunder::image::Image left = viewer.keep("53-focus-lost");
    for (int i = 0; i < 3; ++i) viewer.freshStatus();
    CHECK(sceneDifference(left, viewer.keep("54-later")) == 0);

    screen.act(kFind + "windowfocus");
    REQUIRE(viewer.becomes("focused", true));
    CHECK(sceneDifference(left, viewer.keep("55-focus-again")) == 0);
    viewer.keyDown("Right");
    CHECK(sceneDifference(left, viewer.keep("56-held-again")) > 0.05);
    viewer.keyUp("Right");
    viewer.quit();
}

TEST_CASE("A minimised window stands still and goes on where it was", "[viewer]") {
    Screen screen(1000, 600);
    screen.manageWindows();
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "cpu"});
    viewer.clickScene(0.5, 0.45);
    CHECK(eventually([&] { return viewer.status()["bonds_broken"] > 20; }));
    // Asked for again until the window manager is up.
    REQUIRE(eventually([&] {
        screen.act(kFind + "windowminimize");
        return viewer.freshStatus()["minimised"] == true;
    }));
    const Json hidden = viewer.freshStatus(), later = viewer.freshStatus();
    CHECK(later["time"] == hidden["time"]);
    screen.act(kFind + "windowmap");
    REQUIRE(viewer.becomes("minimised", false));
    CHECK(viewer.becomes("window", Json::array({900, 560})));
    const Json shown = viewer.freshStatus();
    // The time it was away for is not made up for.
    CHECK(shown["time"] > hidden["time"]);
    CHECK(shown["time"] < hidden["time"].get<double>() + 60);
    CHECK(shown["bonds_broken"] >= hidden["bonds_broken"]);
    viewer.quit();
}

TEST_CASE("A window that is closed by its button ends as one that quits", "[viewer]") {
    Screen screen(1000, 600);
    screen.manageWindows();
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560"});
    viewer.key("t");
    viewer.clickScene(0.5, 0.45);
    REQUIRE_FALSE(fs::exists(viewer.settings()));
    // Asked for again until the window manager is up.
    REQUIRE(eventually([&] {
        if (viewer.running()) screen.act("key F10");
        return !viewer.running();
    }));
    viewer.endsSoundly();
    CHECK_THAT(textOf(viewer.settings()), Catch::Contains("\ntool = \"push\"\n"));
}

TEST_CASE("On a screen of small pixels everything is as much larger", "[viewer]") {
    const Screen plain(1280, 720), fine(2560, 1440, 192);
    const auto look = [](const Screen& screen, const std::string& name) {
        ViewerUnderTest viewer(screen, {"brick", "--size", "1280x720", "--solver", "cpu"});
        viewer.click("tab.material");
        viewer.clickScene(0.5, 0.5);
        const Json now = viewer.freshStatus(), widgets = viewer.widgets();
        checkLooksRight(viewer.keep(name), now["view"][0]);
        viewer.quit();
        return std::pair(now, widgets);
    };
    const auto [small, smallWidgets] = look(plain, "57-plain-screen");
    const auto [large, largeWidgets] = look(fine, "58-fine-screen");
    CHECK(small["view"][0] == kPanel);
    CHECK(large["view"][0] == 2 * kPanel);
    CHECK(large["window"] == Json::array({2560, 1440}));
    // The same widgets have room, each about twice as large; letters come in whole pixels.
    REQUIRE(smallWidgets.size() == largeWidgets.size());
    for (const auto& [name, place] : smallWidgets.items()) {
        INFO(name);
        for (int side = 0; side < 4; ++side)
            CHECK(std::abs(largeWidgets[name][side].get<double>() - 2 * place[side].get<double>()) <
                  40);
    }
    // Windows have the size that they had the last time, not twice that each time.
    for (int time = 0; time < 2; ++time) {
        ViewerUnderTest viewer(fine, {"brick"});
        CHECK(viewer.freshStatus()["window"] == Json::array({2560, 1440}));
        viewer.quit();
        CHECK_THAT(textOf(viewer.settings()), Catch::Contains("\nwidth = 1280\nheight = 720\n"));
    }
}

TEST_CASE("What was chosen is chosen the next time", "[viewer]") {
    const Screen screen(1000, 600);
    {
        ViewerUnderTest viewer(screen, {"--size", "900x500", "--solver", "cpu"});
        viewer.key("m");
        viewer.key("t");
        viewer.click("solver.scatter");
        REQUIRE(viewer.becomes("solver", "scatter"));
        viewer.quit();
    }
    {
        ViewerUnderTest viewer(screen, {});
        const Json now = viewer.freshStatus();
        CHECK(now["mesh"] == "simulation");
        CHECK(now["tool"] == "push");
        CHECK(now["solver"] == "scatter");
        CHECK(now["window"] == Json::array({900, 500}));
        viewer.quit();
    }
    // A file that somebody broke is said, and does not keep the viewer from starting.
    std::ofstream(screen.folder() / "home" / "sunder" / "viewer.toml") << "samples = \"many\"\n";
    ViewerUnderTest viewer(screen, {"--solver", "cpu"});
    REQUIRE(viewer.eventCount("problem") == 1);
    CHECK_THAT(viewer.events("problem")[0]["text"].get<std::string>(),
               Catch::Contains("viewer.toml:1") && Catch::Contains("samples"));
    viewer.quit();
}

TEST_CASE("Without a screen it says so, and what to do", "[viewer]") {
    const fs::path output = fs::temp_directory_path() / "sunder-no-screen.txt";
    Child child({SUNDER_PROGRAM, "view"}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}, output);
    CHECK(child.wait(60) == 3);
    const std::string text = textOf(output);
    fs::remove(output);
    CHECK_THAT(text, Catch::StartsWith("sunder: ") && Catch::Contains("sunder run"));
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
}

TEST_CASE("Wrong use is a sentence before any window opens", "[viewer]") {
    const fs::path output = fs::temp_directory_path() / "sunder-wrong-view.txt";
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"woood"},
                                               {"--solver", "fast"},
                                               {"--size", "big"},
                                               {"--log", "/no/such/folder/log"},
                                               {"--out", "/no/such/folder"}}) {
        std::vector<std::string> command{SUNDER_PROGRAM, "view"};
        command.insert(command.end(), arguments.begin(), arguments.end());
        Child child(command, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}, output);
        INFO(arguments.back());
        CHECK(child.wait(60) == 2);
        const std::string text = textOf(output);
        CHECK_THAT(text, Catch::Contains(arguments.back()));
        CHECK(std::count(text.begin(), text.end(), '\n') == 1);
    }
    fs::remove(output);
}
