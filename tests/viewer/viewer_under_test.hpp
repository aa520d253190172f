#pragma once
#include <array>
#include <nlohmann/json.hpp>

#include "screen.hpp"

/// `sunder view` on a screen, driven by mouse and keyboard and watched through its --log.
class ViewerUnderTest {
  public:
    using Json = nlohmann::json;

    /// Waits for the first frames. `set`: more of its environment.
    ViewerUnderTest(const Screen&, const std::vector<std::string>& arguments,
                    const std::map<std::string, std::string>& set = {});

    /// The newest line about how things are.
    Json status();
    /// Where each widget is: name to left, top, right, bottom, in pixels of the window.
    Json widgets();
    /// A new one, of a frame after one that began when this was called or later.
    Json freshStatus();
    /// Lines of this name so far.
    std::vector<Json> events(const std::string& name);
    std::size_t eventCount(const std::string& name) { return events(name).size(); }
    /// Waits for one more than `seen`, and returns the newest.
    Json nextEvent(const std::string& name, std::size_t seen);
    bool running() { return child_.running(); }

    // --- the mouse: each waits until the viewer has seen it ---
    /// Puts the mouse onto a widget by its name, clicks. The test fails where there is none.
    void click(const std::string& widget) { clickAt(widget, 0.5, 0.5); }
    /// Where in a widget, as shares of its width and height. `held`: a key meanwhile, such as ctrl.
    void clickAt(const std::string& widget, double x, double y, int button = 1,
                 const std::string& held = {});
    /// left, top, right, bottom in pixels, of a widget that is there or comes.
    std::array<double, 4> place(const std::string& widget);
    /// To a place of the scene, 0 to 1 from its top left.
    void pointAt(double x, double y);
    void clickScene(double x, double y, int button = 1, const std::string& held = {});
    /// Onto the edge of the panel, where nothing is marked for it at once.
    void pointAway();
    void press(int button = 1);
    void release(int button = 1);

    /// xdotool with these arguments, all of whose events come in one frame, however fast it is.
    void inOneFrame(const std::string& arguments);
    /// xdotool's words for a move to the middle of a widget, and to a place of the scene.
    std::string moveToWidget(const std::string& widget, double x = 0.5, double y = 0.5);
    std::string moveToScene(double x, double y);

    // --- the keyboard ---
    /// By xdotool's name, or by its place on the keyboard: a keycode from 10 on.
    void key(const std::string& name);
    void keyDown(const std::string& name);
    void keyUp(const std::string& name);
    /// Into a text field, instead of what it holds, and Return.
    void type(const std::string& widget, const std::string& text);
    /// The same after Ctrl and click, into a widget that is there to be dragged. `x`: where in it.
    void typeNumber(const std::string& widget, const std::string& text, double x = 0.5);

    /// Waits until the status has this value.
    bool becomes(const std::string& field, const Json& value);

    /// What is on the screen, also kept as NAME.png for whoever wants to look.
    sunder::image::Image keep(const std::string& name);

    /// Ctrl+Q, and endsSoundly().
    void quit();
    /// Waits for its end: this exit code, no GL error and nothing left on the GPU.
    void endsSoundly(int exitCode = 0);
    void send(int signal) const { child_.send(signal); }
    std::string output() const;
    /// Text of a file in the folder that it was told to write to.
    std::string written(const std::string& file) const;
    /// What it remembers for the next time.
    std::filesystem::path settings() const;

  private:
    /// All so far.
    const std::vector<Json>& lines();
    Json newest(const std::string& event);
    void clickHere(const std::string& move, int button, const std::string& held);
    void enter(const std::string& text);

    const Screen& screen_;
    std::filesystem::path log_, output_;
    std::vector<Json> lines_;
    std::streamoff read_ = 0;  // how far of the log
    Child child_;
};
