#include "gl/window.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "gl/glfw_library.hpp"

namespace sunder::gl {
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

GLFWwindow* makeWindow(const Window::Options& options, bool told) {
    hintCoreContext(4, 1, true, told);
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
        glfwMakeContextCurrent(handle());
        initialise(glfwGetProcAddress, "window");
        glfwSetWindowUserPointer(handle(), this);
        listen();
        setVsync(options.vsync);
        glfwShowWindow(handle());
        look();
        if (options.fullScreen) setFullScreen(true);
        glfwGetCursorPos(handle(), &cursorX_, &cursorY_);
    }

    void poll(double patience) override {
        input_.keys.clear();
        input_.clicks.clear();
        input_.dropped.clear();
        input_.wheel = 0;
        if (minimised()) patience = 0.1;
        if (patience > 0)
            glfwWaitEventsTimeout(patience);
        else
            glfwPollEvents();
        look();
        // The desktop's coordinates are larger than pixels on some high-density screens.
        const double density = now_.density;
        input_.moveX = cursorX_ * density - input_.x;
        input_.moveY = cursorY_ * density - input_.y;
        input_.x = cursorX_ * density;
        input_.y = cursorY_ * density;
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

  private:
    struct Handle {
        explicit Handle(const Options& options) : handle(makeWindow(options, true)) {
            if (!handle) handle = makeWindow(options, false);
            if (!handle)
                throw ContextError(
                    "a window with OpenGL 4.1 core cannot be opened: " + glfwErrorText() + kAdvice);
        }
        ~Handle() {
            glfwMakeContextCurrent(nullptr);
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
        glfwSetKeyCallback(handle(), [](GLFWwindow* w, int key, int code, int action, int) {
            of(w).takeKey(keyOf(key, code), action);
        });
        glfwSetMouseButtonCallback(handle(), [](GLFWwindow* w, int button, int action, int) {
            of(w).takeButton(button, action);
        });
        glfwSetCursorPosCallback(handle(), [](GLFWwindow* w, double x, double y) {
            of(w).cursorX_ = x;
            of(w).cursorY_ = y;
        });
        glfwSetCursorEnterCallback(
            handle(), [](GLFWwindow* w, int entered) { of(w).input_.inside = entered != 0; });
        glfwSetScrollCallback(handle(), [](GLFWwindow* w, double x, double y) {
            of(w).input_.wheel += y != 0 ? y : x;  // macOS turns it with Shift held
            of(w).input_.wheelWith = of(w).modifiers();
        });
        glfwSetDropCallback(handle(), [](GLFWwindow* w, int count, const char** paths) {
            for (int i = 0; i < count; ++i) of(w).input_.dropped.emplace_back(paths[i]);
        });
        glfwSetWindowFocusCallback(handle(), [](GLFWwindow* w, int focused) {
            // Releases that go elsewhere are never heard of.
            if (!focused) of(w).letGo();
        });
        // Other callbacks may be put in front; they hand on what they get.
    }
    void takeKey(Key key, int action) {
        if (key == Key::None) return;
        if (action == GLFW_PRESS) {
            input_.keys.push_back({key, modifiers()});
            input_.held.insert(key);
        } else if (action == GLFW_RELEASE) {
            input_.held.erase(key);
        }
    }
    void takeButton(int button, int action) {
        if (button < 0 || button >= kMouseButtons) return;
        input_.buttonHeld[button] = action == GLFW_PRESS;
        if (action != GLFW_PRESS) return;
        const double density = now_.density;
        input_.clicks.push_back({static_cast<MouseButton>(button), cursorX_ * density,
                                 cursorY_ * density, modifiers()});
    }
    void letGo() {
        input_.held.clear();
        std::fill(std::begin(input_.buttonHeld), std::end(input_.buttonHeld), false);
    }

    /// As of the event that is being handled.
    Modifiers modifiers() const {
        const auto down = [&](int left, int right) {
            return glfwGetKey(handle(), left) == GLFW_PRESS ||
                   glfwGetKey(handle(), right) == GLFW_PRESS;
        };
        return {down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) ||
                    down(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER),
                glfwGetKey(handle(), GLFW_KEY_LEFT_ALT) == GLFW_PRESS};  // the right one is AltGr
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
    Input input_;
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

}  // namespace sunder::gl
