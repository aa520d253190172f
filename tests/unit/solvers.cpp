#include "support/solver_under_test.hpp"

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
    return cpuSolvers();
}
