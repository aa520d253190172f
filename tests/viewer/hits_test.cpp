// What the mouse and the keys 1 to 9 do to a wall.
#include "catch.hpp"
#include "pictures.hpp"
#include "viewer_under_test.hpp"

using Json = nlohmann::json;

namespace {

int broken(ViewerUnderTest& viewer) {
    return viewer.status()["bonds_broken"];
}

}  // namespace

TEST_CASE("Hits break the wall with every solver, each of which goes on with it as it is",
          "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "cpu"});
    const sunder::image::Image whole = viewer.keep("01-wood-at-rest");
    checkLooksRight(whole);
    CHECK(broken(viewer) == 0);
    viewer.clickScene(0.5, 0.45);
    REQUIRE(viewer.eventCount("hit") == 1);
    CHECK(eventually([&] { return broken(viewer) > 20; }));
    CHECK(sceneDifference(whole, viewer.keep("02-wood-hit")) > 0.005);

    // What is clicked acts in the very frame that hears of it.
    const Json hit = viewer.events("hit")[0];
    REQUIRE(viewer.eventCount("pushed") == 1);
    const Json pushed = viewer.events("pushed")[0];
    CHECK(pushed["frame"] == hit["frame"]);
    CHECK(pushed["steps"] > 0);

    for (const std::string solver : {"scatter", "auto", "reference", "gather", "cpu"}) {
        INFO(solver);
        const int before = viewer.freshStatus()["bonds_broken"];
        const double time = viewer.status()["time"];
        viewer.click("solver." + solver);
        REQUIRE(viewer.becomes("solver", solver));
        // The state is kept: what is broken stays broken, and time goes on from where it was.
        const Json now = viewer.freshStatus();
        CHECK(now["bonds_broken"] >= before);
        CHECK(now["time"] >= time);
        CHECK(eventually([&] { return viewer.status()["time"] > now["time"]; }));

        viewer.key("r");
        REQUIRE(viewer.becomes("bonds_broken", 0));
        viewer.clickScene(0.45, 0.4);
        CHECK(eventually([&] { return broken(viewer) > 20; }));
        CHECK(viewer.status()["solver"] == solver);
        CHECK(viewer.status()["nan"] == 0);
        CHECK(sceneDifference(whole, viewer.keep("03-hit-with-" + solver)) > 0.005);
    }
    CHECK(viewer.eventCount("restart") == 5);
    CHECK(viewer.eventCount("problem") == 0);
    viewer.quit();
}

TEST_CASE("A mouse that is dragged shoots one blow after the other along its way", "[viewer]") {
    const Screen screen(900, 560);
    // Light blows leave no holes in rubber, through which the next could go.
    ViewerUnderTest viewer(screen, {"rubber", "--size", "900x560", "--solver", "cpu"});
    viewer.typeNumber("strength", "5");
    viewer.pointAt(0.35, 0.5);
    viewer.press();
    for (int i = 1; i <= 8; ++i) viewer.pointAt(0.35 + 0.04 * i, 0.5);
    viewer.release();
    viewer.keep("04-dragged");
    const std::vector<Json> hits = viewer.events("hit");
    REQUIRE(hits.size() >= 3);
    for (std::size_t i = 1; i < hits.size(); ++i)
        CHECK(hits[i]["place"][0] > hits[i - 1]["place"][0]);
    // Let go, it only points.
    viewer.pointAt(0.4, 0.5);
    viewer.pointAt(0.45, 0.5);
    CHECK(viewer.eventCount("hit") == hits.size());
    viewer.quit();
}

TEST_CASE("Push presses the wall away while the button is held, pull draws it near", "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"rubber", "--size", "900x560", "--solver", "cpu"});
    constexpr double kX = 0.5, kY = 0.45;
    // How far it is from the wall that stands still to its middle, as a shot there finds it.
    const auto depth = [&] {
        viewer.click("tool.Shoot");
        const std::size_t seen = viewer.eventCount("hit");
        viewer.clickScene(kX, kY);
        return viewer.nextEvent("hit", seen)["place"][2].get<double>();
    };
    viewer.key("space");
    REQUIRE(viewer.becomes("paused", true));
    const double rest = depth();
    // Frame by frame, so that it is looked at in its first swing on any machine.
    const auto hold = [&](const std::string& tool, const std::string& name) {
        viewer.key("r");
        viewer.click("tool." + tool);
        viewer.typeNumber("strength", "300");
        viewer.pointAt(kX, kY);
        const std::size_t seen = viewer.eventCount("pushed");
        viewer.press();
        constexpr int kFrames = 4;
        for (int i = 0; i < kFrames; ++i) viewer.key("period");
        CHECK(viewer.eventCount("pushed") == seen + kFrames);
        viewer.keep(name);
        viewer.release();
        return depth();
    };
    // The camera looks against z; at rest it is where it was to less than a millimetre.
    CHECK(hold("Push", "05-pushed") < rest - 0.005);
    CHECK(hold("Pull", "06-pulled") > rest + 0.005);

    // While time runs it goes on for as long as the button is down.
    viewer.click("tool.Push");
    viewer.key("r");
    viewer.key("space");
    viewer.pointAt(kX, kY);
    const std::size_t seen = viewer.eventCount("pushed");
    viewer.press();
    CHECK(eventually([&] { return viewer.eventCount("pushed") > seen + 2; }));
    CHECK(viewer.events("pushed").back()["steps"] > 0);
    viewer.release();
    const std::size_t pushes = viewer.eventCount("pushed");
    viewer.freshStatus();
    CHECK(viewer.eventCount("pushed") == pushes);
    viewer.quit();
}

TEST_CASE("Strength and radius of hits are set by slider and wheel", "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "cpu"});
    const auto turn = [&](const std::string& held, int button, const std::string& event) {
        const std::size_t seen = viewer.eventCount(event);
        viewer.pointAt(0.5, 0.45);
        viewer.keyDown(held);
        screen.act("click " + std::to_string(button));
        viewer.keyUp(held);
        return viewer.nextEvent(event, seen)["value"].get<double>();
    };
    constexpr int kUp = 4, kDown = 5;
    const double notch = 1.1;
    viewer.typeNumber("strength", "20");
    CHECK(turn("shift", kUp, "strength") == Approx(20 * notch));
    CHECK(turn("shift", kDown, "strength") == Approx(20));
    viewer.clickAt("strength", 0.9, 0.5);
    CHECK(turn("shift", kDown, "strength") > 50);
    viewer.typeNumber("radius", "0.1");
    CHECK(turn("ctrl", kUp, "radius") == Approx(0.1 * notch));
    CHECK(turn("ctrl", kDown, "radius") == Approx(0.1));
    // Only the wheel alone moves the camera, and nothing of this was a hit.
    CHECK(viewer.eventCount("hit") == 0);

    // The ring around the mouse is as much larger.
    viewer.key("space");
    viewer.pointAway();
    const sunder::image::Image without = viewer.keep("07-no-ring");
    viewer.pointAt(0.5, 0.45);
    const double small = sceneDifference(without, viewer.keep("08-small-ring"));
    CHECK(small > 0);
    viewer.clickAt("radius", 0.75, 0.5);
    const double radius = turn("ctrl", kDown, "radius");
    CHECK(radius > 0.3);
    const double large = sceneDifference(without, viewer.keep("09-large-ring"));
    // Not as exactly: a thin line's pixels count when they change by enough.
    CHECK(large / small > 0.5 * radius / 0.1);

    // A weak blow breaks nothing, a strong one does.
    viewer.typeNumber("radius", "0.3");
    viewer.typeNumber("strength", "1");
    viewer.key("space");
    viewer.clickScene(0.5, 0.45);
    CHECK(viewer.eventCount("hit") == 1);
    const double time = viewer.status()["time"];
    CHECK(eventually([&] { return viewer.status()["time"].get<double>() > time + 0.2; }));
    CHECK(broken(viewer) == 0);
    viewer.typeNumber("strength", "90");
    viewer.clickScene(0.5, 0.45);
    CHECK(eventually([&] { return broken(viewer) > 20; }));

    // Push and pull have a strength of their own.
    viewer.key("t");
    CHECK(viewer.becomes("tool", "push"));
    CHECK(turn("shift", kUp, "strength") == Approx(300 * notch));
    viewer.quit();
    const std::string remembered = textOf(viewer.settings());
    CHECK_THAT(remembered, Catch::Contains("\nshot = 90\n"));
    CHECK_THAT(remembered, Catch::Contains("\nradius = 0.3\n"));
    CHECK_THAT(remembered, Catch::Contains("\npush = 330"));
}

TEST_CASE("A cell that is clicked to look at it has its stress beside it", "[viewer]") {
    const Screen screen(900, 640);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x640", "--solver", "cpu"});
    viewer.key("space");
    const auto outlined = [](const sunder::image::Image& image) {
        return share(image, sceneOf(image), 255, 200, 60);
    };
    const auto lettered = [](const sunder::image::Image& image) {
        return share(image, sceneOf(image), 240, 240, 235);
    };
    viewer.click("tab.measure");
    viewer.pointAway();
    const sunder::image::Image before = viewer.keep("25-nothing-looked-at");
    REQUIRE(outlined(before) == 0);
    const double plots = viewer.place("plot.frame")[1];

    for (const std::string held : {"ctrl", "alt", ""}) {
        INFO(held);
        // Without a key it takes a tool of its own.
        while (held.empty() && viewer.status()["tool"] != "look") viewer.key("t");
        const std::size_t seen = viewer.eventCount("look");
        viewer.clickScene(0.55, 0.4, 1, held);
        const Json look = viewer.nextEvent("look", seen);
        CHECK(look["cell"] >= 0);
        CHECK(look["cell"] < 30 * 20);
        viewer.pointAway();
        const sunder::image::Image looked =
            viewer.keep("26-looked-at-" + (held.empty() ? "tool" : held));
        CHECK(outlined(looked) > 1e-4);
        CHECK(lettered(looked) > lettered(before));
        // The panel has a row for each thing that is to be known of it, instead of a hint.
        CHECK(viewer.place("plot.frame")[1] > plots + 40);

        viewer.key("Escape");
        const sunder::image::Image after = viewer.keep("27-no-longer");
        CHECK(outlined(after) == 0);
        CHECK(viewer.place("plot.frame")[1] == plots);
    }
    CHECK(viewer.eventCount("hit") == 0);
    viewer.quit();
}

TEST_CASE("Keys of digits and signs count by their place, letters by what they print", "[viewer]") {
    for (const std::string layout : {"fr", "de"}) {
        INFO(layout);
        const Screen screen(640, 400);
        screen.layOutKeyboard(layout);
        ViewerUnderTest viewer(screen, {"brick", "--size", "640x400", "--solver", "cpu"});
        // Keycodes of X are those of the places 1 to 9.
        for (int number = 1; number <= 9; ++number) {
            const std::size_t seen = viewer.eventCount("preset");
            viewer.key(std::to_string(9 + number));
            CHECK(viewer.nextEvent("preset", seen)["number"] == number);
        }
        CHECK(viewer.eventCount("hit") == 9);
        CHECK(eventually([&] { return broken(viewer) > 20; }));
        constexpr const char *kSlower = "34", *kFaster = "35";  // right of P
        viewer.key(kSlower);
        CHECK(viewer.becomes("speed", 0.5));
        viewer.key(kSlower);
        CHECK(viewer.becomes("speed", 0.25));
        viewer.key(kFaster);
        CHECK(viewer.becomes("speed", 0.5));
        // On a French keyboard that is where others have a semicolon.
        CHECK(viewer.status()["mesh"] == "display");
        viewer.key("m");
        CHECK(viewer.becomes("mesh", "simulation"));
        viewer.keep("28-hit-by-keys-" + layout);
        viewer.quit();
    }
}
