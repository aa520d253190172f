#include "viewer_under_test.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "catch.hpp"

namespace fs = std::filesystem;

ViewerUnderTest::ViewerUnderTest(const Screen& screen, const std::vector<std::string>& arguments,
                                 const std::string& home)
    : screen_(screen),
      log_(screen.folder() / "log.jsonl"),
      output_(screen.folder() / "output.txt") {
    fs::remove(log_);
    std::vector<std::string> command{SUNDER_PROGRAM, "view",  "--log",
                                     log_.string(),  "--out", screen.folder().string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    child_ = Child(command,
                   {{"DISPLAY", screen.display()},
                    {"WAYLAND_DISPLAY", ""},
                    {"LIBGL_ALWAYS_SOFTWARE", "1"},
                    {"XDG_CONFIG_HOME", (screen.folder() / home).string()}},
                   output_);
    const bool started = eventually([&] { return eventCount("status") >= 2 || !running(); });
    INFO(output());
    REQUIRE(started);
    REQUIRE(running());
}

std::string ViewerUnderTest::output() const {
    std::ifstream file(output_);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<ViewerUnderTest::Json> ViewerUnderTest::lines() {
    std::vector<Json> result;
    std::ifstream file(log_);
    for (std::string line; std::getline(file, line);)
        if (Json json = Json::parse(line, nullptr, false); !json.is_discarded())
            result.push_back(std::move(json));
    return result;
}

std::vector<ViewerUnderTest::Json> ViewerUnderTest::events(const std::string& name) {
    std::vector<Json> result = lines();
    std::erase_if(result, [&](const Json& line) { return line["event"] != name; });
    return result;
}

ViewerUnderTest::Json ViewerUnderTest::status() {
    const std::vector<Json> all = events("status");
    REQUIRE_FALSE(all.empty());
    return all.back();
}

ViewerUnderTest::Json ViewerUnderTest::freshStatus() {
    // The first one that comes may be of a frame that began before; the second has what happened,
    // but the window is laid out for it in the third.
    const std::size_t seen = eventCount("status");
    REQUIRE(eventually([&] { return eventCount("status") >= seen + 3 || !running(); }));
    const Json now = status();
    INFO(output());
    REQUIRE(running());
    return now;
}

void ViewerUnderTest::clickAt(const std::string& widget, double x, double y) {
    INFO("widget " << widget);
    // It may come with a frame that is still being drawn.
    freshStatus();
    Json place;
    REQUIRE(eventually([&] {
        const Json widgets = status()["widgets"];
        if (widgets.contains(widget)) place = widgets[widget];
        return !place.is_null() || !running();
    }));
    REQUIRE(running());
    REQUIRE_FALSE(place.is_null());
    const double left = place[0], top = place[1], right = place[2], bottom = place[3];
    screen_.act("mousemove " + std::to_string(std::lround(left + x * (right - left))) + " " +
                std::to_string(std::lround(top + y * (bottom - top))));
    // The interface has to see the mouse before the button.
    freshStatus();
    screen_.act("mousedown 1");
    freshStatus();
    screen_.act("mouseup 1");
    freshStatus();
}

void ViewerUnderTest::click(const std::string& widget) {
    clickAt(widget, 0.5, 0.5);
}

void ViewerUnderTest::clickScene(double x, double y, int button) {
    const Json view = status()["view"];
    const double left = view[0], top = view[1], width = view[2], height = view[3];
    screen_.act("mousemove " + std::to_string(std::lround(left + x * width)) + " " +
                std::to_string(std::lround(top + y * height)));
    freshStatus();
    screen_.act("mousedown " + std::to_string(button));
    freshStatus();
    screen_.act("mouseup " + std::to_string(button));
    freshStatus();
}

void ViewerUnderTest::key(const std::string& name) {
    screen_.act("key " + name);
    freshStatus();
}

void ViewerUnderTest::type(const std::string& widget, const std::string& text) {
    click(widget);
    // Text fields only see keys that are down as a frame begins.
    const auto hold = [&](const std::string& down, const std::string& up) {
        screen_.act(down);
        freshStatus();
        screen_.act(up);
        freshStatus();
    };
    hold("keydown ctrl keydown a", "keyup a keyup ctrl");
    screen_.act("type --delay 40 '" + text + "'");
    freshStatus();
    // Out of the field again, or keys would go there.
    hold("keydown Return", "keyup Return");
}

bool ViewerUnderTest::becomes(const std::string& field, const Json& value) {
    return eventually([&] { return status()[field] == value || !running(); }) && running();
}

sunder::Image ViewerUnderTest::keep(const std::string& name) {
    freshStatus();
    const sunder::Image image = screen_.picture();
    fs::create_directories(SUNDER_VIEWER_PICTURES);
    sunder::writePng(fs::path(SUNDER_VIEWER_PICTURES) / (name + ".png"), image);
    return image;
}

void ViewerUnderTest::quit() {
    screen_.act("key ctrl+q");
    const int code = child_.wait(60);
    INFO(output());
    CHECK(code == 0);
    CHECK(events("gl_error").empty());
    const std::vector<Json> closed = events("closed");
    REQUIRE(closed.size() == 1);
    CHECK(closed[0]["gl_bytes_left"] == 0);
}

namespace {

template <class Visit>
double shareOf(const sunder::Image& image, int left, int top, int width, int height,
               Visit&& counts) {
    REQUIRE(left >= 0);
    REQUIRE(top >= 0);
    REQUIRE(left + width <= image.width);
    REQUIRE(top + height <= image.height);
    std::int64_t count = 0;
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x)
            count += counts(3 * (std::size_t(y) * image.width + x));
    return static_cast<double>(count) / (static_cast<double>(width) * height);
}

}  // namespace

double difference(const sunder::Image& a, const sunder::Image& b, int left, int top, int width,
                  int height) {
    REQUIRE(a.width == b.width);
    REQUIRE(a.height == b.height);
    return shareOf(a, left, top, width, height, [&](std::size_t at) {
        int most = 0;
        for (std::size_t i = at; i < at + 3; ++i)
            most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
        return most > 12;
    });
}

double share(const sunder::Image& image, int left, int top, int width, int height, int red,
             int green, int blue) {
    return shareOf(image, left, top, width, height, [&](std::size_t at) {
        return std::abs(image.pixels[at] - red) < 12 &&
               std::abs(image.pixels[at + 1] - green) < 12 &&
               std::abs(image.pixels[at + 2] - blue) < 12;
    });
}

int colours(const sunder::Image& image, int left, int top, int width, int height) {
    std::set<int> found;
    shareOf(image, left, top, width, height, [&](std::size_t at) {
        found.insert((image.pixels[at] >> 4) << 8 | (image.pixels[at + 1] >> 4) << 4 |
                     image.pixels[at + 2] >> 4);
        return true;
    });
    return static_cast<int>(found.size());
}
