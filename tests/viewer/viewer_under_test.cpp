#include "viewer_under_test.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "catch.hpp"

namespace fs = std::filesystem;

namespace {

std::string moveTo(double x, double y) {
    return "mousemove " + std::to_string(std::lround(x)) + " " + std::to_string(std::lround(y));
}

}  // namespace

ViewerUnderTest::ViewerUnderTest(const Screen& screen, const std::vector<std::string>& arguments,
                                 const std::map<std::string, std::string>& set)
    : screen_(screen),
      log_(screen.folder() / "日本 Jürgen.jsonl"),
      output_(screen.folder() / "output.txt") {
    fs::remove(log_);
    std::vector<std::string> command{SUNDER_PROGRAM, "view",  "--log",
                                     log_.string(),  "--out", screen.folder().string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    std::map<std::string, std::string> environment = set;
    environment.insert({{"DISPLAY", screen.display()},
                        {"WAYLAND_DISPLAY", ""},
                        {"LIBGL_ALWAYS_SOFTWARE", "1"},
                        {"XDG_CONFIG_HOME", (screen.folder() / "home").string()}});
    child_ = Child(command, environment, output_);
    const bool started = eventually([&] { return eventCount("status") >= 2 || !running(); });
    INFO(output());
    REQUIRE(started);
    REQUIRE(running());
}

std::string ViewerUnderTest::output() const {
    return textOf(output_);
}

const std::vector<ViewerUnderTest::Json>& ViewerUnderTest::lines() {
    std::ifstream file(log_);
    file.seekg(read_);
    for (std::string line; std::getline(file, line) && !file.eof();) {
        read_ = file.tellg();
        lines_.push_back(Json::parse(line));
    }
    return lines_;
}

std::vector<ViewerUnderTest::Json> ViewerUnderTest::events(const std::string& name) {
    std::vector<Json> result;
    for (const Json& line : lines())
        if (line["event"] == name) result.push_back(line);
    return result;
}

ViewerUnderTest::Json ViewerUnderTest::nextEvent(const std::string& name, std::size_t seen) {
    INFO("event " << name);
    REQUIRE(eventually([&] { return eventCount(name) > seen || !running(); }));
    REQUIRE(running());
    return events(name).back();
}

ViewerUnderTest::Json ViewerUnderTest::newest(const std::string& event) {
    const std::vector<Json>& all = lines();
    const auto found = std::find_if(all.rbegin(), all.rend(),
                                    [&](const Json& line) { return line["event"] == event; });
    INFO("event " << event);
    REQUIRE(found != all.rend());
    return *found;
}

ViewerUnderTest::Json ViewerUnderTest::status() {
    return newest("status");
}

ViewerUnderTest::Json ViewerUnderTest::widgets() {
    return newest("widgets")["places"];
}

ViewerUnderTest::Json ViewerUnderTest::freshStatus() {
    // The first one that comes may be of a frame that began before; the next frame has what
    // happened, but the window is laid out for it in the one after. A minimised window has no
    // frames, but looks at what happened each time.
    const std::size_t seen = lines().size();
    Json now;
    REQUIRE(eventually([&] {
        const std::vector<Json>& all = lines();
        int count = 0;
        std::int64_t first = 0;
        for (std::size_t i = seen; i < all.size(); ++i) {
            if (all[i]["event"] != "status") continue;
            const std::int64_t frame = all[i]["frame"];
            if (count++ == 0) first = frame;
            if (frame < first + 2 && count < 3) continue;
            now = all[i];
        }
        return !now.is_null() || !running();
    }));
    INFO(output());
    REQUIRE(running());
    return now;
}

std::array<double, 4> ViewerUnderTest::place(const std::string& widget) {
    INFO("widget " << widget);
    Json place;
    REQUIRE(eventually([&] {
        const Json places = widgets();
        if (places.contains(widget)) place = places[widget];
        return !place.is_null() || !running();
    }));
    REQUIRE(running());
    return {place[0], place[1], place[2], place[3]};
}

void ViewerUnderTest::clickAt(const std::string& widget, double x, double y, int button,
                              const std::string& held) {
    clickHere(moveToWidget(widget, x, y), button, held);
}

std::string ViewerUnderTest::moveToWidget(const std::string& widget, double x, double y) {
    const auto [left, top, right, bottom] = place(widget);
    return moveTo(left + x * (right - left), top + y * (bottom - top));
}

void ViewerUnderTest::inOneFrame(const std::string& arguments) {
    // A frame begun by a stopped viewer has seen none of it, and the next one sees all of it.
    child_.pause();
    screen_.act(arguments);
    child_.resume();
    freshStatus();
}

void ViewerUnderTest::clickHere(const std::string& move, int button, const std::string& held) {
    // The interface has to see the mouse before the button.
    screen_.act((held.empty() ? "" : "keydown " + held + " ") + move);
    freshStatus();
    press(button);
    screen_.act("mouseup " + std::to_string(button) + (held.empty() ? "" : " keyup " + held));
    freshStatus();
}

void ViewerUnderTest::pointAt(double x, double y) {
    screen_.act(moveToScene(x, y));
    freshStatus();
}

std::string ViewerUnderTest::moveToScene(double x, double y) {
    const Json view = status()["view"];
    const double left = view[0], top = view[1], width = view[2], height = view[3];
    return moveTo(left + x * width, top + y * height);
}

void ViewerUnderTest::pointAway() {
    screen_.act("mousemove 4 200");
    freshStatus();
}

void ViewerUnderTest::press(int button) {
    screen_.act("mousedown " + std::to_string(button));
    freshStatus();
}

void ViewerUnderTest::release(int button) {
    screen_.act("mouseup " + std::to_string(button));
    freshStatus();
}

void ViewerUnderTest::clickScene(double x, double y, int button, const std::string& held) {
    clickHere(moveToScene(x, y), button, held);
}

void ViewerUnderTest::key(const std::string& name) {
    screen_.act("key " + name);
    freshStatus();
}

void ViewerUnderTest::keyDown(const std::string& name) {
    screen_.act("keydown " + name);
    freshStatus();
}

void ViewerUnderTest::keyUp(const std::string& name) {
    screen_.act("keyup " + name);
    freshStatus();
}

void ViewerUnderTest::type(const std::string& widget, const std::string& text) {
    click(widget);
    // Text fields only see keys that are down as a frame begins.
    screen_.act("keydown ctrl keydown a");
    freshStatus();
    screen_.act("keyup a keyup ctrl");
    freshStatus();
    enter(text);
}

void ViewerUnderTest::typeNumber(const std::string& widget, const std::string& text, double x) {
    // What it held is selected.
    clickAt(widget, x, 0.5, 1, "ctrl");
    enter(text);
}

void ViewerUnderTest::enter(const std::string& text) {
    screen_.act("type --delay 40 '" + text + "'");
    freshStatus();
    keyDown("Return");
    keyUp("Return");
}

bool ViewerUnderTest::becomes(const std::string& field, const Json& value) {
    return eventually([&] { return status()[field] == value || !running(); }) && running();
}

sunder::image::Image ViewerUnderTest::keep(const std::string& name) {
    freshStatus();
    const sunder::image::Image image = screen_.picture();
    fs::create_directories(SUNDER_VIEWER_PICTURES);
    sunder::image::writePng(fs::path(SUNDER_VIEWER_PICTURES) / (name + ".png"), image);
    return image;
}

void ViewerUnderTest::quit() {
    screen_.act("key ctrl+q");
    endsSoundly();
}

void ViewerUnderTest::endsSoundly(int exitCode) {
    const int code = child_.wait(60);
    INFO(output());
    CHECK(code == exitCode);
    for (const Json& e : events("gl_error")) UNSCOPED_INFO(e.dump());
    CHECK(events("gl_error").empty());
    const std::vector<Json> closed = events("closed");
    REQUIRE(closed.size() == 1);
    CHECK(closed[0]["gl_bytes_left"] == 0);
}

std::string ViewerUnderTest::written(const std::string& file) const {
    return textOf(screen_.folder() / file);
}

fs::path ViewerUnderTest::settings() const {
    return screen_.folder() / "home" / "sunder" / "viewer.toml";
}
