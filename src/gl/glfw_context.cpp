// Headless contexts where there is no EGL: a GLFW window that is never shown. Main thread only, as
// GLFW demands.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string>

#include "gl/headless_context.hpp"

namespace sunder::gl {
namespace {

std::string errorText() {
    const char* description = nullptr;
    const int code = glfwGetError(&description);
    return description ? description : "GLFW error " + std::to_string(code);
}

struct Library {
    Library() {
        if (!glfwInit()) throw ContextError("glfwInit failed: " + errorText());
    }
    ~Library() { glfwTerminate(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
};

GLFWwindow* makeWindow(int major, int minor, bool debug) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debug ? GLFW_TRUE : GLFW_FALSE);
    return glfwCreateWindow(64, 64, "Sunder", nullptr, nullptr);
}

class GlfwContext final : public Context {
  public:
    explicit GlfwContext(const std::string& description) {
        glfwMakeContextCurrent(window_.handle);
        initialise(glfwGetProcAddress, description);
    }

  private:
    struct Window {
        Window() : handle(makeWindow(4, 1, true)) {
            if (handle) return;
            const std::string problem = errorText();
            // An older context is made only so that initialise() can say which version there is.
            handle = makeWindow(3, 2, false);
            if (!handle)
                throw ContextError("glfwCreateWindow for OpenGL 4.1 core failed: " + problem);
        }
        ~Window() {
            glfwMakeContextCurrent(nullptr);
            glfwDestroyWindow(handle);
        }
        Window(const Window&) = delete;
        Window& operator=(const Window&) = delete;
        GLFWwindow* handle;
    };

    Library library_;
    Window window_;
};

}  // namespace

std::vector<HeadlessCandidate> headlessCandidates() {
    const std::string description = "hidden window";
    auto open = [description]() -> std::unique_ptr<Context> {
        return std::make_unique<GlfwContext>(description);
    };
    return {{0, description, false, open}};
}

}  // namespace sunder::gl
