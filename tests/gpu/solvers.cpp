#include <regex>

#include "gpu/test_context.hpp"
#include "support/solver_under_test.hpp"

/// Renderer and version. Without llvmpipe's width of vectors, on which its results do not depend.
std::string driverUnderTest() {
    const sunder::gl::DeviceInfo& info = testContext().info();
    const std::string renderer =
        std::regex_replace(info.renderer, std::regex(", [0-9]+ bits\\)"), ")");
    return renderer + ", " + info.version;
}

std::vector<SolverUnderTest> solversUnderTest() {
    return gpuSolvers();
}
