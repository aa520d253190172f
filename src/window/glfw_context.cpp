// Headless contexts where there is no EGL: a GLFW window that is never shown. Main thread only, as
// GLFW demands.
#include "window/glfw_library.hpp"
#include "window/headless_context.hpp"

namespace sunder::window {

using namespace core;

namespace {

GLFWwindow* makeWindow(Profile profile, int major, int minor, bool debug, bool told) {
    hintContext(profile, major, minor, debug, told);
    return glfwCreateWindow(64, 64, "Sunder", nullptr, nullptr);
}

class GlfwContext final : public Context {
  public:
    GlfwContext(const std::string& description, Profile profile) : window_(profile) {
        bindContext();
        initialise(description);
    }
    gl::Driver::LoadFunction loadFunction() const override { return glfwGetProcAddress; }

  private:
    void bindContext() override { glfwMakeContextCurrent(window_.handle); }

    struct Window {
        explicit Window(Profile profile)
            : handle(newestContext([profile](int minor, bool told) {
                  return makeWindow(profile, 4, minor, true, told);
              })) {
            if (handle) return;
            const std::string problem = glfwErrorText();
            // An older context is made only so that initialise() can say which version there is.
            handle = makeWindow(profile, 3, 2, false, false);
            if (!handle)
                throw DeviceError("glfwCreateWindow for OpenGL 4.1 core failed: " + problem);
        }
        ~Window() {
            if (glfwGetCurrentContext() == handle) glfwMakeContextCurrent(nullptr);
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
    auto open = [description](Profile profile) -> std::unique_ptr<Context> {
        return std::make_unique<GlfwContext>(description, profile);
    };
    return {{0, description, false, open}};
}

}  // namespace sunder::window
