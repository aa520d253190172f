#pragma once
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "window/context.hpp"

struct GLFWwindow;

namespace sunder::window {

/// A key: letters by what the layout prints on it, in upper case; digits and signs by what an
/// American keyboard prints in that place; the others by these.
enum class Key : int {
    None = 0,
    Space = ' ',
    Escape = 256,
    Enter,
    Tab,
    Home,
    Left,
    Right,
    Up,
    Down,
    PageUp,
    PageDown,
    F1,
    F2,
    F3,
    F4,
    F5,
    F6,
    F7,
    F8,
    F9,
    F10,
    F11,
    F12,
};
constexpr Key key(char printed) {
    return static_cast<Key>(printed);
}

enum class MouseButton { Left, Right, Middle };
inline constexpr int kMouseButtons = 3;

struct Modifiers {
    bool shift = false, control = false, alt = false;
};

/// Something that mouse or keyboard did, as it was at that time: a frame may be long, and hold a
/// press, a way and a release. Places are in pixels of the framebuffer, from the top left.
struct InputEvent {
    enum class Kind {
        Move,       ///< the pointer, by `moveX` and `moveY`
        Enter,      ///< it came into the window
        Leave,      ///< or left it
        Press,      ///< `button`
        Release,    ///< likewise
        Wheel,      ///< `wheelX` and `wheelY`
        KeyDown,    ///< `key`; repeats of a held key are left out
        KeyUp,      ///< likewise
        Character,  ///< `character` was typed
        Focus,      ///< the window has the keyboard from now on
        Blur,       ///< it has lost it; what was held is let go
    };
    Kind kind{};
    double x = 0, y = 0;  ///< the pointer
    Modifiers with;
    double moveX = 0, moveY = 0;
    MouseButton button{};
    double wheelX = 0, wheelY = 0;  ///< notches, to the left and away from the hand is positive
    Key key = Key::None;
    unsigned character = 0;  ///< Unicode
    /// As GLFW has them, for the interface's own backend.
    struct {
        int key = 0, scancode = 0, modifiers = 0;
    } glfw;
};

/// What mouse and keyboard did since the last Window::poll(), in order, and how they are now.
struct Input {
    std::vector<InputEvent> events;
    std::set<Key> held;
    bool buttonHeld[kMouseButtons] = {};
    bool anyButton() const { return buttonHeld[0] || buttonHeld[1] || buttonHeld[2]; }
    bool inside = true;                ///< the window, the pointer
    double x = 0, y = 0;               ///< the pointer
    std::vector<std::string> dropped;  ///< paths of files that were dragged onto the window
};

/// A window with a GL 4.1 core debug context, and its mouse and keyboard. Main thread only. The
/// default framebuffer holds 8-bit sRGB values as they are; it has neither depth nor samples.
class Window : public Context {
  public:
    struct Options {
        std::string title;
        int width = 1280, height = 720;  ///< as the desktop measures
        bool fullScreen = false, vsync = true;
    };
    /// Throws DeviceError, with one sentence, where there is no screen or no GL 4.1.
    static std::unique_ptr<Window> open(const Options&);

    /// Takes in what happened since the last time. Waits up to `patience` s for something to
    /// happen; 0.1 s while the window is minimised, as there is nothing to draw.
    virtual void poll(double patience) = 0;
    /// Of that time. Nothing is held once the focus is lost.
    virtual const Input& input() const = 0;
    virtual void swap() = 0;
    /// Binds its framebuffer, all of it; colours are written as they are, without a conversion to
    /// sRGB.
    void bind() const;
    /// The same, filled with a colour.
    void clear(float red, float green, float blue) const;

    virtual bool closing() const = 0;
    virtual bool minimised() const = 0;
    virtual bool focused() const = 0;
    virtual int width() const = 0;   ///< pixels of the framebuffer; 0 while minimised
    virtual int height() const = 0;  ///< likewise
    /// As Options have it, of the window when not full screen: a window opened with these is as
    /// large again, on the same screen.
    virtual int plainWidth() const = 0;
    virtual int plainHeight() const = 0;  ///< likewise
    /// By how much letters must be larger than 96 dots per inch ask for, in framebuffer pixels.
    virtual float contentScale() const = 0;

    virtual bool fullScreen() const = 0;
    virtual void setFullScreen(bool) = 0;
    virtual void setVsync(bool) = 0;

    /// For the interface's own backend.
    virtual GLFWwindow* handle() const = 0;
};

}  // namespace sunder::window
