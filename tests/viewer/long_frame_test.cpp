// What mouse and keyboard did within one frame, when frames are long: each thing at its own place,
// in order.
#include "catch.hpp"
#include "viewer_under_test.hpp"

using Json = nlohmann::json;

namespace {

const std::string kClick = " mousedown 1 mouseup 1 ";

double apart(const Json& one, const Json& other) {
    double sum = 0;
    for (const char* what : {"position", "target"})
        for (int axis = 0; axis < 3; ++axis)
            sum += std::abs(one[what][axis].get<double>() - other[what][axis].get<double>());
    return sum;
}

}  // namespace

TEST_CASE("However long a frame, a click beside the wall leaves the camera where it is",
          "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "cpu"});
    const Json home = viewer.freshStatus()["camera"];
    const std::string here = viewer.moveToScene(0.05, 0.1), away = viewer.moveToScene(0.9, 0.9);
    viewer.inOneFrame(away);
    for (const int button : {1, 2, 3}) {
        INFO("button " << button);
        const std::string number = std::to_string(button);
        viewer.inOneFrame(here + " mousedown " + number + " mouseup " + number + " " + away);
        CHECK(viewer.freshStatus()["camera"] == home);
        // Pressed in the frame that brings the mouse: only the way from there on turns it.
        viewer.inOneFrame(here + " mousedown " + number);
        CHECK(viewer.freshStatus()["camera"] == home);
        viewer.inOneFrame("mouseup " + number + " " + away);
        CHECK(viewer.freshStatus()["camera"] == home);
    }
    CHECK(viewer.eventCount("hit") == 0);
    viewer.quit();
}

TEST_CASE("However long a frame, a drag turns the camera by its own way", "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "cpu"});
    const std::string here = viewer.moveToScene(0.05, 0.1), away = viewer.moveToScene(0.9, 0.9);
    const std::string way = " mousemove_relative 30 12 mousemove_relative 20 -4 ";
    for (const std::string button : {"1", "2", "3"}) {
        INFO("button " << button);
        viewer.inOneFrame(here);
        viewer.inOneFrame("mousedown " + button);
        viewer.inOneFrame("mousemove_relative 30 12");
        viewer.inOneFrame("mousemove_relative 20 -4");
        viewer.inOneFrame("mouseup " + button);
        const Json slowly = viewer.freshStatus()["camera"];
        viewer.key("Home");
        CHECK(apart(viewer.freshStatus()["camera"], slowly) > 0.1);
        viewer.inOneFrame(away + " " + here + " mousedown " + button + way + "mouseup " + button +
                          " " + away);
        CHECK(apart(viewer.freshStatus()["camera"], slowly) < 1e-9);
        viewer.key("Home");
    }
    viewer.quit();
}

TEST_CASE("However long a frame, every click on a tab or a button counts", "[viewer]") {
    const Screen screen(900, 640);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x640", "--solver", "cpu"});
    const std::string scene = viewer.moveToScene(0.5, 0.3);
    const auto shown = [&](const char* widget) { return viewer.widgets().contains(widget); };
    // From a tab to the next, and away again before the frame ends.
    for (int i = 0; i < 2; ++i)
        for (const auto& [tab, widget] : {std::pair{"tab.wall", "build"},
                                          {"tab.material", "material"},
                                          {"tab.measure", "plot.frame"},
                                          {"tab.play", "tool.Shoot"}}) {
            INFO(tab);
            const std::string there = viewer.moveToWidget(tab);
            viewer.inOneFrame(there + kClick + (i == 0 ? there : scene));
            CHECK(eventually([&] { return shown(widget); }));
        }
    // Several in one frame, one after the other.
    const std::string pause = viewer.moveToWidget("pause"), step = viewer.moveToWidget("step");
    viewer.inOneFrame(viewer.moveToWidget("tab.wall") + kClick + pause + kClick +
                      viewer.moveToWidget("tab.play") + kClick + scene);
    CHECK(viewer.becomes("paused", true));
    CHECK(eventually([&] { return shown("tool.Shoot"); }));
    const double time = viewer.freshStatus()["time"];
    viewer.inOneFrame(step + kClick + kClick + kClick + scene);
    CHECK(viewer.freshStatus()["time"].get<double>() == Approx(time + 3.0 / 60));
    viewer.inOneFrame(viewer.moveToWidget("tool.Pull") + kClick +
                      viewer.moveToWidget("style.Both") + kClick + scene + " click 4");
    CHECK(viewer.becomes("tool", "pull"));
    CHECK(viewer.becomes("style", "overlay"));
    // A click that begins on a button and ends beside it is none, as ever.
    viewer.inOneFrame(viewer.moveToWidget("tool.Push") + " mousedown 1 " + scene + " mouseup 1");
    CHECK(viewer.freshStatus()["tool"] == "pull");
    CHECK(viewer.eventCount("hit") == 0);
    viewer.quit();
}

TEST_CASE("However long a frame, hits are where they were clicked, with the keys held then",
          "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"rubber", "--size", "900x560", "--solver", "cpu"});
    viewer.typeNumber("strength", "5");
    viewer.key("space");
    const std::string left = viewer.moveToScene(0.35, 0.5), right = viewer.moveToScene(0.6, 0.5);
    const std::string panel = viewer.moveToWidget("tool.Shoot");
    viewer.inOneFrame(panel + " " + right + kClick + left + kClick + panel);
    const std::vector<Json> hits = viewer.events("hit");
    REQUIRE(hits.size() == 2);
    CHECK(hits[0]["place"][0] > hits[1]["place"][0].get<double>() + 0.3);
    viewer.inOneFrame(left + " keydown ctrl" + kClick + "keyup ctrl " + right + kClick + panel);
    CHECK(viewer.eventCount("look") == 1);
    CHECK(viewer.eventCount("hit") == 3);

    // A push that begins and ends in one frame acts in that frame, at its own place.
    viewer.click("tool.Push");
    const std::size_t pushed = viewer.eventCount("pushed");
    viewer.key("space");
    viewer.inOneFrame(panel + " " + right + kClick + panel);
    CHECK(viewer.eventCount("pushed") == pushed + 1);
    viewer.quit();
}

TEST_CASE("However long a frame, the wheel turns what is under it, and keys come in order",
          "[viewer]") {
    const Screen screen(900, 640);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x640", "--solver", "cpu"});
    const auto distance = [&] {
        const Json camera = viewer.freshStatus()["camera"];
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis)
            sum += std::pow(
                camera["position"][axis].get<double>() - camera["target"][axis].get<double>(), 2);
        return std::sqrt(sum);
    };
    const double far = distance();
    const std::string scene = viewer.moveToScene(0.5, 0.3), panel = viewer.moveToWidget("pause");
    viewer.inOneFrame(scene + " click 4 click 4 " + panel + " click 5 click 5 click 5");
    CHECK(distance() == Approx(far / 1.21));
    viewer.inOneFrame(scene + " keydown shift click 4 keyup shift click 5 " + panel);
    CHECK(distance() == Approx(far / 1.1));
    CHECK(viewer.eventCount("strength") == 1);

    viewer.click("tab.wall");
    viewer.inOneFrame(viewer.moveToWidget("scene_name") + kClick +
                      "key ctrl+a key m key y key minus key w key Return " + scene + " key space");
    REQUIRE(eventually([&] { return viewer.eventCount("saved_scene") == 1; }));
    CHECK_THAT(viewer.events("saved_scene")[0]["path"].get<std::string>(),
               Catch::EndsWith("/my-w.toml"));
    CHECK(viewer.becomes("paused", true));
    viewer.inOneFrame("key m key space key m key m");
    CHECK(viewer.becomes("mesh", "simulation"));
    CHECK(viewer.becomes("paused", false));
    viewer.quit();
}
