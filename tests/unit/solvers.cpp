#include "cpu/cpu_solver.hpp"
#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"

using namespace sunder;

/// `cpu` gives the same bits on any machine with the same library of functions.
std::string driverUnderTest() {
#if defined(__linux__) && defined(__x86_64__)
    return "Linux x86-64";
#elif defined(_WIN32)
    return "Windows";
#elif defined(__APPLE__)
    return "macOS";
#else
    return "another system";
#endif
}

std::vector<SolverUnderTest> solversUnderTest() {
    return {
        {"reference",
         [](const World& world) -> std::unique_ptr<Solver> {
             return std::make_unique<ReferenceSolver>(world);
         },
         1.2e-16, false, true},
        {"cpu",
         [](const World& world) -> std::unique_ptr<Solver> {
             return std::make_unique<CpuSolver>(world);
         },
         6e-8, true, true},
    };
}
