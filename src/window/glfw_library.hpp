#pragma once
// For the files that know GLFW: nothing else includes this.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>
#include <string>

#include "core/types.hpp"
#include "window/context.hpp"

namespace sunder::window {

/// What went wrong last, in GLFW's words.
inline std::string glfwErrorText() {
    const char* description = nullptr;
    const int code = glfwGetError(&description);
    return description ? description : "GLFW error " + std::to_string(code);
}

inline bool isInEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
}

/// Where no Wayland can be, GLFW 3.4 would let libwayland say so on stderr before it tries X11.
inline void hintPlatform() {
#if defined(GLFW_PLATFORM_X11) && !defined(_WIN32) && !defined(__APPLE__)
    if (!isInEnvironment("XDG_RUNTIME_DIR") && !isInEnvironment("WAYLAND_DISPLAY") &&
        !isInEnvironment("WAYLAND_SOCKET"))
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

/// GLFW, for as long as one of these lives. It belongs to the process and to its main thread.
/// `advice` ends the sentence of the DeviceError.
struct GlfwLibrary {
    explicit GlfwLibrary(const std::string& advice = {}) {
        hintPlatform();
        if (!glfwInit())
            throw core::DeviceError("no window can be opened: " + glfwErrorText() + advice);
        ++users();
    }
    ~GlfwLibrary() {
        if (--users() == 0) glfwTerminate();
    }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;

  private:
    static int& users() {
        static int count = 0;
        return count;
    }
};

/// Hints for a window with an OpenGL context of this version; the window is not shown. `told`:
/// of a reset of the device, as egl_context.cpp has it.
inline void hintContext(Profile profile, int major, int minor, bool debug, bool told) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
    const bool core = profile == Profile::Core;
    glfwWindowHint(GLFW_OPENGL_PROFILE,
                   core ? GLFW_OPENGL_CORE_PROFILE : GLFW_OPENGL_COMPAT_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, core ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debug ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, told ? GLFW_LOSE_CONTEXT_ON_RESET : GLFW_NO_ROBUSTNESS);
}

}  // namespace sunder::window
