#include "window/window.hpp"

#include "gl/functions.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "window/glfw_library.hpp"

namespace sunder::window {

using namespace core;

namespace {

const std::string kAdvice = "; without a screen, `sunder run SCENE` makes pictures and videos";

Key keyOf(int key, int scancode) {
    constexpr std::pair<int, Key> kOthers[] = {
        {GLFW_KEY_SPACE, Key::Space},       {GLFW_KEY_ESCAPE, Key::Escape},
        {GLFW_KEY_ENTER, Key::Enter},       {GLFW_KEY_TAB, Key::Tab},
        {GLFW_KEY_HOME, Key::Home},         {GLFW_KEY_LEFT, Key::Left},
        {GLFW_KEY_RIGHT, Key::Right},       {GLFW_KEY_UP, Key::Up},
        {GLFW_KEY_DOWN, Key::Down},         {GLFW_KEY_PAGE_UP, Key::PageUp},
        {GLFW_KEY_PAGE_DOWN, Key::PageDown}};
    for (const auto& [glfw, ours] : kOthers)
        if (key == glfw) return ours;
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return static_cast<Key>(static_cast<int>(Key::F1) + key - GLFW_KEY_F1);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
        return static_cast<Key>('0' + key - GLFW_KEY_KP_0);
    // Letters count by what the layout prints, wherever they are: on a French keyboard, W is where
    // Z is on others. Digits and signs count by their place: there 1 prints &, and what prints ] on
    // an American keyboard prints + on a German one. A letter's place that prints a sign is that
    // sign.
    const auto isLetter = [](int c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const char* name = glfwGetKeyName(key, scancode);
    const char printed = name && name[0] > ' ' && name[1] == '\0' ? name[0] : '\0';
    const bool letterPlace = key >= GLFW_KEY_A && key <= GLFW_KEY_Z;
    if (printed && (isLetter(printed) || letterPlace))
        return static_cast<Key>(std::toupper(static_cast<unsigned char>(printed)));
    return key > ' ' && key < 128 ? static_cast<Key>(key) : Key::None;
}

GLFWwindow* makeWindow(const Window::Options& options, int minor, bool told) {
    hintContext(Profile::Core, 4, minor, true, told);
    // Pictures are drawn into a target of their own and copied: samples and depth are there.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SAMPLES, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    return glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
}

class GlfwWindow final : public Window {
  public:
    explicit GlfwWindow(const Options& options)
        : library_(kAdvice), window_(options), width_(options.width), height_(options.height) {
        bindContext();
        initialise("window");
        glfwSetWindowUserPointer(handle(), this);
        listen();
        setVsync(options.vsync);
        glfwShowWindow(handle());
        look();
        if (options.fullScreen) setFullScreen(true);
        glfwGetCursorPos(handle(), &cursorX_, &cursorY_);
        input_ = taken();
    }

    void poll(double patience) override {
        if (minimised()) patience = 0.1;
        if (patience > 0)
            glfwWaitEventsTimeout(patience);
        else
            glfwPollEvents();
        look();
        // Whatever comes until the next time, as when the window fills the screen, is kept for it.
        input_ = taken();
        coming_.events.clear();
        coming_.dropped.clear();
    }
    const Input& input() const override { return input_; }
    void swap() override { glfwSwapBuffers(handle()); }

    bool closing() const override { return glfwWindowShouldClose(handle()); }
    bool minimised() const override {
        return now_.iconified || now_.width == 0 || now_.height == 0;
    }
    bool focused() const override { return now_.focused; }
    int width() const override { return now_.width; }
    int height() const override { return now_.height; }
    int plainWidth() const override { return plain(width_); }
    int plainHeight() const override { return plain(height_); }
    float contentScale() const override { return now_.scale; }

    bool fullScreen() const override { return glfwGetWindowMonitor(handle()) != nullptr; }
    void setFullScreen(bool wanted) override {
        if (wanted == fullScreen()) return;
        if (!wanted) {
            glfwSetWindowMonitor(handle(), nullptr, left_, top_, width_, height_, GLFW_DONT_CARE);
            glfwFocusWindow(handle());  // where no window manager gives it back
        } else if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
            glfwGetWindowPos(handle(), &left_, &top_);
            const GLFWvidmode* mode = glfwGetVideoMode(monitor);
            glfwSetWindowMonitor(handle(), monitor, 0, 0, mode->width, mode->height,
                                 mode->refreshRate);
        }
        setVsync(vsync_);  // some drivers forget it
        look();
    }
    void setVsync(bool wanted) override {
        vsync_ = wanted;
        glfwSwapInterval(wanted ? 1 : 0);
    }

    GLFWwindow* handle() const override { return window_.handle; }
    gl::Driver::LoadFunction loadFunction() const override { return glfwGetProcAddress; }

  private:
    void bindContext() override { glfwMakeContextCurrent(handle()); }

    struct Handle {
        explicit Handle(const Options& options)
            : handle(newestContext(
                  [&](int minor, bool told) { return makeWindow(options, minor, told); })) {
            if (!handle)
                throw DeviceError(
                    "a window with OpenGL 4.1 core cannot be opened: " + glfwErrorText() + kAdvice);
        }
        ~Handle() {
            if (glfwGetCurrentContext() == handle) glfwMakeContextCurrent(nullptr);
            glfwDestroyWindow(handle);
        }
        Handle(const Handle&) = delete;
        Handle& operator=(const Handle&) = delete;
        GLFWwindow* handle;
    };

    static GlfwWindow& of(GLFWwindow* window) {
        return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
    }

    void listen() {
        using Kind = InputEvent::Kind;
        glfwSetKeyCallback(handle(), [](GLFWwindow* w, int key, int code, int action, int) {
            if (action != GLFW_REPEAT) of(w).takeKey(key, code, action == GLFW_PRESS);
        });
        glfwSetCharCallback(handle(), [](GLFWwindow* w, unsigned character) {
            of(w).happened(Kind::Character).character = character;
        });
        glfwSetMouseButtonCallback(handle(), [](GLFWwindow* w, int button, int action, int) {
            of(w).takeButton(button, action == GLFW_PRESS);
        });
        glfwSetCursorPosCallback(handle(),
                                 [](GLFWwindow* w, double x, double y) { of(w).takeMove(x, y); });
        glfwSetCursorEnterCallback(handle(), [](GLFWwindow* w, int entered) {
            of(w).coming_.inside = entered != 0;
            of(w).happened(entered ? Kind::Enter : Kind::Leave);
        });
        glfwSetScrollCallback(handle(), [](GLFWwindow* w, double x, double y) {
            InputEvent& turned = of(w).happened(Kind::Wheel);
            turned.wheelX = x;
            turned.wheelY = y;
        });
        glfwSetDropCallback(handle(), [](GLFWwindow* w, int count, const char** paths) {
            for (int i = 0; i < count; ++i) of(w).coming_.dropped.emplace_back(paths[i]);
        });
        glfwSetWindowFocusCallback(handle(), [](GLFWwindow* w, int focused) {
            of(w).happened(focused ? Kind::Focus : Kind::Blur);
            // Releases that go elsewhere are never heard of.
            if (!focused) of(w).letGo();
        });
    }
    /// The event is for the caller to complete.
    InputEvent& happened(InputEvent::Kind kind) {
        InputEvent& event = coming_.events.emplace_back();
        event.kind = kind;
        event.x = cursorX_ * now_.density;
        event.y = cursorY_ * now_.density;
        event.glfw.modifiers = modifiers();
        const auto held = [&](int mask) { return (event.glfw.modifiers & mask) != 0; };
        event.with = {held(GLFW_MOD_SHIFT), held(GLFW_MOD_CONTROL | GLFW_MOD_SUPER),
                      glfwGetKey(handle(), GLFW_KEY_LEFT_ALT) == GLFW_PRESS};  // right: AltGr
        return event;
    }
    void takeMove(double x, double y) {
        const double fromX = std::exchange(cursorX_, x), fromY = std::exchange(cursorY_, y);
        InputEvent& moved = happened(InputEvent::Kind::Move);
        moved.moveX = (x - fromX) * now_.density;
        moved.moveY = (y - fromY) * now_.density;
    }
    void takeKey(int code, int scancode, bool down) {
        const Key key = keyOf(code, scancode);
        InputEvent& event = happened(down ? InputEvent::Kind::KeyDown : InputEvent::Kind::KeyUp);
        event.key = key;
        event.glfw.key = code;
        event.glfw.scancode = scancode;
        if (!down)
            coming_.held.erase(key);
        else if (key != Key::None)
            coming_.held.insert(key);
    }
    void takeButton(int button, bool down) {
        if (button < 0 || button >= kMouseButtons) return;
        coming_.buttonHeld[button] = down;
        happened(down ? InputEvent::Kind::Press : InputEvent::Kind::Release).button =
            static_cast<MouseButton>(button);
    }
    void letGo() {
        coming_.held.clear();
        std::fill(std::begin(coming_.buttonHeld), std::end(coming_.buttonHeld), false);
    }
    Input taken() const {
        Input input = coming_;
        // The desktop's coordinates are larger than pixels on some high-density screens.
        input.x = cursorX_ * now_.density;
        input.y = cursorY_ * now_.density;
        return input;
    }

    /// GLFW's bits, as of the event that is being handled: those that it hands on lack, on X11, the
    /// key that the event is about.
    int modifiers() const {
        const auto bit = [&](int left, int right, int mask) {
            const bool down = glfwGetKey(handle(), left) == GLFW_PRESS ||
                              glfwGetKey(handle(), right) == GLFW_PRESS;
            return down ? mask : 0;
        };
        return bit(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, GLFW_MOD_SHIFT) |
               bit(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL) |
               bit(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT) |
               bit(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER, GLFW_MOD_SUPER);
    }
    /// Asks once a frame: on X11 each question is a way to the server and back.
    void look() {
        glfwGetFramebufferSize(handle(), &now_.width, &now_.height);
        int width = 0, height = 0;
        glfwGetWindowSize(handle(), &width, &height);
        now_.density = width > 0 ? static_cast<double>(now_.width) / width : 1;
        float x = 1, y = 1;
        glfwGetWindowContentScale(handle(), &x, &y);
        now_.scale = std::clamp(std::max(x, y), 0.5f, 8.f);
        now_.iconified = glfwGetWindowAttrib(handle(), GLFW_ICONIFIED);
        now_.focused = glfwGetWindowAttrib(handle(), GLFW_FOCUSED);
        if (fullScreen() || minimised()) return;
        width_ = width;
        height_ = height;
    }
    /// As Options have it: GLFW makes a window as much larger as letters have to be, except where
    /// the desktop's coordinates are larger than pixels.
    int plain(int length) const {
        return static_cast<int>(std::lround(length * now_.density / now_.scale));
    }

    GlfwLibrary library_;
    Handle window_;
    Input input_, coming_;              // as of the last poll(), and since then
    double cursorX_ = 0, cursorY_ = 0;  // as the desktop measures
    int left_ = 0, top_ = 0;
    int width_, height_;  ///< as the desktop measures, when not full screen
    struct {
        int width = 0, height = 0;  ///< of the framebuffer
        double density = 1;         ///< its pixels in what the desktop measures by
        float scale = 1;
        bool iconified = false, focused = false;
    } now_;
    bool vsync_ = true;
};

}  // namespace

void Window::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glViewport(0, 0, width(), height());
}

void Window::clear(float red, float green, float blue) const {
    bind();
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

std::unique_ptr<Window> Window::open(const Options& options) {
    return std::make_unique<GlfwWindow>(options);
}

}  // namespace sunder::window
