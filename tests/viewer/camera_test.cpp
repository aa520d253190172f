// The viewer's camera in a real window: the wall fits, and the eye stays above the ground.
#include <algorithm>
#include <array>
#include <cmath>

#include "catch.hpp"
#include "pictures.hpp"
#include "viewer_under_test.hpp"

using Json = nlohmann::json;

namespace {

using Place = std::array<double, 3>;

Place minus(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Place cross(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Place unit(const Place& a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

/// How far out in the view the corners of the brick wall are, 2 x 0.2 m and so wide: 1 is its edge.
double outermost(const Json& status, double width) {
    const Json& camera = status["camera"];
    const Place eye = camera["position"], target = camera["target"];
    const Place ahead = unit(minus(target, eye)), right = unit(cross(ahead, {0, 1, 0}));
    const Place up = cross(right, ahead);
    const double tangent = std::tan(camera["field_of_view"].get<double>() * 3.14159265358979 / 360);
    const double aspect = status["view"][2].get<double>() / status["view"][3].get<double>();
    double most = 0;
    for (const double x : {-width / 2, width / 2})
        for (const double y : {0.0, 2.0})
            for (const double z : {-0.1, 0.1}) {
                const Place to = minus({x, y, z}, eye);
                const double half = tangent * dot(to, ahead);
                most = std::max({most, std::abs(dot(to, right)) / (half * aspect),
                                 std::abs(dot(to, up)) / half});
            }
    return most;
}

/// Share of the view's outermost two pixels that is red, as bricks are.
double redAtTheEdge(const sunder::image::Image& image, const Json& view) {
    constexpr int kWide = 2;
    const int left = view[0], width = view[2], height = view[3];
    int red = 0, all = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (std::min({x, y, width - 1 - x, height - 1 - y}) >= kWide) continue;
            const std::uint8_t* p = &image.pixels[3 * (std::size_t(y) * image.width + left + x)];
            ++all;
            red += p[0] > 1.35 * p[1];
        }
    return static_cast<double>(red) / all;
}

}  // namespace

TEST_CASE("The wall fits what the panel leaves of the window, whatever its shape", "[viewer]") {
    const Screen screen(2560, 1080);
    const std::string resize = "search --name '^Sunder$' windowsize ";
    ViewerUnderTest viewer(screen, {"brick", "--size", "900x600", "--solver", "cpu"});
    viewer.key("space");
    viewer.pointAway();
    const auto fits = [&](const std::string& name, double width = 3.2) {
        const sunder::image::Image image = viewer.keep(name);
        const Json now = viewer.freshStatus();
        CAPTURE(name, now["camera"].dump(), now["view"].dump());
        CHECK(outermost(now, width) <= 1);
        CHECK(outermost(now, width) > 0.6);  // and is no smaller than it must be
        CHECK(redAtTheEdge(image, now["view"]) == 0);
    };
    const auto shape = [&](int width, int height) {
        screen.act(resize + std::to_string(width) + " " + std::to_string(height));
        REQUIRE(viewer.becomes("window", Json::array({width, height})));
        viewer.freshStatus();
    };
    fits("90-fits-900x600");
    shape(2560, 1080);
    fits("91-fits-2560x1080");
    shape(700, 900);
    fits("92-fits-700x900");
    shape(900, 600);
    viewer.key("Tab");
    fits("93-fits-without-panel");
    viewer.key("Tab");

    // Where the user has put it, it stays; Home fits the window as it is then.
    viewer.pointAt(0.5, 0.3);
    screen.act("click 4");
    const Json own = viewer.freshStatus()["camera"];
    shape(2560, 1080);
    CHECK(viewer.freshStatus()["camera"] == own);
    shape(900, 600);
    CHECK(viewer.freshStatus()["camera"] == own);
    viewer.key("Home");
    viewer.pointAway();
    fits("94-fits-after-home");

    // A wider wall is another one.
    viewer.click("tab.wall");
    viewer.typeNumber("size", "6", 0.15);
    viewer.click("build");
    viewer.pointAway();
    fits("95-fits-wider", 6);
    viewer.quit();
}

TEST_CASE("Dragged, turned or driven down, the camera stays above the ground", "[viewer]") {
    const Screen screen(900, 560);
    const std::vector<std::string> window{"--size", "900x560", "--solver", "cpu"};
    {
        std::vector<std::string> arguments = window;
        arguments.insert(arguments.begin(), "brick");
        ViewerUnderTest viewer(screen, arguments);
        const auto height = [&] {
            return viewer.freshStatus()["camera"]["position"][1].get<double>();
        };
        REQUIRE(height() > 1);
        const std::string sky = viewer.moveToScene(0.9, 0.1);
        for (const std::string button : {"1", "3", "2"}) {
            INFO("button " << button);
            // Up with the mouse goes the wall, and down the camera.
            for (int i = 0; i < 12; ++i)
                viewer.inOneFrame(sky + " mousedown " + button +
                                  " mousemove_relative -- 0 -50 mouseup " + button);
            CHECK(height() > 0);
            CHECK(height() < 0.06);
            viewer.keep("96-on-the-ground-" + button);
            viewer.key("Home");
        }
        for (const std::string key : {"Down", "q"}) {
            INFO(key);
            viewer.keyDown(key);
            CHECK(eventually([&] { return height() < 0.06; }));
            screen.act(sky);
            for (int i = 0; i < 20; ++i) screen.act("click 5");
            CHECK(height() > 0);
            viewer.keyUp(key);
            viewer.keep("97-driven-down-" + key);
            if (key == "Down") viewer.key("Home");
        }
        // What is saved there is above the ground when it is opened, too.
        viewer.click("tab.wall");
        viewer.type("scene_name", "low");
        REQUIRE(eventually([&] { return viewer.eventCount("saved_scene") == 1; }));
        viewer.quit();
    }
    std::vector<std::string> arguments = window;
    arguments.insert(arguments.begin(), (screen.folder() / "low.toml").string());
    ViewerUnderTest again(screen, arguments);
    CHECK(again.freshStatus()["camera"]["position"][1].get<double>() > 0);
    again.quit();
}
