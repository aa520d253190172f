// Headless contexts where there is no EGL: a GLFW window that is never shown. Main thread only, as
// GLFW demands.
#include "gl/glfw_library.hpp"
#include "gl/headless_context.hpp"

namespace sunder::gl {

using namespace core;

namespace {

GLFWwindow* makeWindow(int major, int minor, bool debug, bool told) {
    hintCoreContext(major, minor, debug, told);
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
        Window() : handle(makeWindow(4, 1, true, true)) {
            if (!handle) handle = makeWindow(4, 1, true, false);
            if (handle) return;
            const std::string problem = glfwErrorText();
            // An older context is made only so that initialise() can say which version there is.
            handle = makeWindow(3, 2, false, false);
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

    GlfwLibrary library_;
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
