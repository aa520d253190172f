#pragma once
#include <nlohmann/json.hpp>

#include "screen.hpp"

/// `sunder view` on a screen, driven by mouse and keyboard and watched through its --log.
class ViewerUnderTest {
  public:
    using Json = nlohmann::json;

    /// Waits for the first frames. `home`: folder of its settings.
    ViewerUnderTest(const Screen&, const std::vector<std::string>& arguments,
                    const std::string& home = "home");

    /// The newest line about how things are.
    Json status();
    /// A new one, of a frame that began after this was called.
    Json freshStatus();
    /// Lines of this name so far.
    std::vector<Json> events(const std::string& name);
    std::size_t eventCount(const std::string& name) { return events(name).size(); }
    bool running() { return child_.running(); }

    /// Puts the mouse onto a widget by its name, clicks. The test fails where there is none.
    void click(const std::string& widget);
    /// Where in a widget, as shares of its width and height.
    void clickAt(const std::string& widget, double x, double y);
    /// The same at a place of the scene, 0 to 1 from its top left.
    void clickScene(double x, double y, int button = 1);
    void key(const std::string& name);
    /// Into a text field, instead of what it holds.
    void type(const std::string& widget, const std::string& text);
    /// Waits until the status has this value.
    bool becomes(const std::string& field, const Json& value);

    /// What is on the screen, also kept as NAME.png for whoever wants to look.
    sunder::Image keep(const std::string& name);

    /// Ctrl+Q; the exit code, and no GL error and nothing left on the GPU.
    void quit();
    std::string output() const;

  private:
    std::vector<Json> lines();

    const Screen& screen_;
    std::filesystem::path log_, output_;
    Child child_;
};

/// Share of pixels in a rectangle that differ by more than a little.
double difference(const sunder::Image&, const sunder::Image&, int left, int top, int width,
                  int height);
/// Share of pixels in a rectangle of about this colour.
double share(const sunder::Image&, int left, int top, int width, int height, int red, int green,
             int blue);
/// How many clearly different colours a rectangle has, at most 4096.
int colours(const sunder::Image&, int left, int top, int width, int height);
