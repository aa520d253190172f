// Losing a context cannot be provoked with Mesa's software driver: here functions of GL say that it
// was.
#include "gl/functions.hpp"

#include <optional>
#include <string>
#include <utility>

#include "catch.hpp"
#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gpu/test_context.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Another value while it lives.
template <class T>
class Instead {
  public:
    Instead(T& place, T value) : place_(place), before_(place) { place = value; }
    ~Instead() { place_ = before_; }
    Instead(const Instead&) = delete;
    Instead& operator=(const Instead&) = delete;

  private:
    T& place_;
    T before_;
};

GLenum GLAD_API_PTR errorOfLost() {
    return GL_CONTEXT_LOST;
}
GLenum GLAD_API_PTR statusOfLost() {
    return GL_GUILTY_CONTEXT_RESET;
}
bool told = false;
GLenum GLAD_API_PTR statusToldOnce() {
    return std::exchange(told, true) ? GL_NO_ERROR : GL_INNOCENT_CONTEXT_RESET;
}

template <class Call>
void checkLost(Call call) {
    CHECK_THROWS_AS(call(), DeviceError);
    CHECK_THROWS_WITH(
        call(), Catch::Contains("the OpenGL context was lost") && Catch::Contains("run it again"));
}

void askEveryWay(window::Context& context) {
    checkLost([&] { context.check(); });
    checkLost([&] { context.takeErrors(); });
}

}  // namespace

TEST_CASE(
    "a context that says it was reset is one sentence, by either extension and by its errors") {
    const auto context = window::createHeadlessContext();  // for each section, as it stays lost
    context->check();
    SECTION("GL_KHR_robustness") {
        const Instead has(gl::functions().KHR_robustness, 1);
        const Instead status(gl::functions().GetGraphicsResetStatus,
                             PFNGLGETGRAPHICSRESETSTATUSPROC{statusOfLost});
        askEveryWay(*context);
    }
    SECTION("GL_ARB_robustness alone") {
        const Instead without(gl::functions().KHR_robustness, 0);
        const Instead has(gl::functions().ARB_robustness, 1);
        const Instead status(gl::functions().GetGraphicsResetStatusARB,
                             PFNGLGETGRAPHICSRESETSTATUSARBPROC{statusOfLost});
        askEveryWay(*context);
    }
    SECTION("neither, and glGetError answers for ever") {
        const Instead without(gl::functions().KHR_robustness, 0);
        const Instead withoutArb(gl::functions().ARB_robustness, 0);
        const Instead error(gl::functions().GetError, PFNGLGETERRORPROC{errorOfLost});
        askEveryWay(*context);
    }
    SECTION("once, as some drivers do") {
        told = false;
        const Instead has(gl::functions().KHR_robustness, 1);
        const Instead status(gl::functions().GetGraphicsResetStatus,
                             PFNGLGETGRAPHICSRESETSTATUSPROC{statusToldOnce});
        askEveryWay(*context);
    }
}

TEST_CASE("what is made in a lost context is no defect of the program, nor of its shaders") {
    window::Context& context = testContext();
    SECTION("a buffer and a texture") {
        const Instead error(gl::functions().GetError, PFNGLGETERRORPROC{errorOfLost});
        checkLost([] { gl::Buffer(4, nullptr, GL_STATIC_DRAW, "numbers"); });
        checkLost([] { gl::makeTexture2D(4, 4, GL_RGBA8, "picture"); });
    }
    SECTION("a shader, which does not compile") {
        const Instead has(gl::functions().KHR_robustness, 1);
        const Instead status(gl::functions().GetGraphicsResetStatus,
                             PFNGLGETGRAPHICSRESETSTATUSPROC{statusOfLost});
        gl::ProgramDescription broken;
        broken.vertex = "broken.vert";
        broken.source = [](std::string_view) -> std::optional<std::string> { return "nonsense\n"; };
        checkLost([&] { gl::Program{broken}; });
    }
    // The functions are back, and all is well again.
    CHECK_NOTHROW(context.check());
}
