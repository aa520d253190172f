#pragma once
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "window/window.hpp"

namespace sunder::view {

/// Dear ImGui in a window, and what all panels share. It draws into the default framebuffer.
class Interface {
  public:
    /// left, top, right, bottom in pixels of the framebuffer, from the top left.
    using Rectangle = std::array<float, 4>;

    explicit Interface(window::Window&);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// What mouse or keyboard did; the next frame of panels takes it in. One such frame sees all
    /// moves as one, but only one press, release or key: what comes next waits for the one after.
    void feed(const window::InputEvent&);
    /// Something was fed that no frame of panels has seen.
    bool fed() const { return fed_; }
    /// Begins a frame of panels. `scale` is on top of the screen's own; letters are made anew when
    /// it changes.
    void begin(double scale);
    /// Ends it without drawing.
    void end();
    /// Fills the window with what panels stand on, before anything is drawn: blending it into every
    /// pixel of a panel costs a software driver most of what the interface costs.
    void clear() const;
    /// Ends it, and draws it.
    void draw();

    /// Pixels (of the interface) for what is this long on a plain screen at scale 1.
    float length(double plain) const { return static_cast<float>(plain) * scale_; }
    /// Pixels of the framebuffer over those of the interface.
    float density() const;
    bool wantsMouse() const;
    /// Somebody types into a field.
    bool wantsKeyboard() const;

    /// Where the widget drawn last is goes by this name until the next frame.
    void mark(const std::string& name);
    const std::map<std::string, Rectangle>& widgets() const { return widgets_; }

    // --- widgets that more than one panel uses; true: clicked ---
    bool button(const std::string& name, const std::string& label, const std::string& help = {});
    bool checkbox(const std::string& name, const std::string& label, bool& value,
                  const std::string& help = {});
    /// Side by side, on as many lines as it takes; the chosen one stands out. −1: nothing new.
    int choice(const std::string& name, std::span<const std::string_view> labels, int chosen,
               std::span<const std::string_view> help = {});
    /// Text in a column of its own, before a widget on the same line.
    void label(const char* text, std::string_view help = {});
    struct Scale {
        double min, max;  ///< from end to end
        bool logarithmic = true;
        double least = min, most = max;             ///< what may be typed
        std::optional<double> home = std::nullopt;  ///< where a right click takes it
        double unit = 1;                            ///< what it is shown and typed in
    };
    /// As wide as the rest of the line. `unit`: its name; "1": a plain number. True while it is
    /// being changed.
    bool slider(const std::string& name, double& value, const Scale&, std::string_view unit,
                std::string_view help);
    /// A heading with room above it.
    void heading(const char* text);
    /// The widget marked last was changed, and the mouse or keyboard has let go of it now.
    bool letGo() const { return letGo_; }
    /// Over the last widget, while the mouse is on it.
    void tooltip(std::string_view text) const;

  private:
    /// Whether a tooltip is to be shown.
    static bool hovered();
    void setScale(float scale);
    void pointMouse() const;

    window::Window& window_;
    float scale_ = 0;
    bool letGo_ = false, fed_ = false;
    struct {
        double x = 0, y = 0;  ///< pixels of the framebuffer
        bool inside = false;
        bool held[window::kMouseButtons] = {};
        double wheelX = 0, wheelY = 0;  ///< notches since the last frame of panels
    } mouse_;
    int modifiers_ = 0;  ///< as GLFW has them
    std::map<std::string, Rectangle> widgets_;
};

}  // namespace sunder::view
