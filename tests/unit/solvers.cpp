#include "support/solver_under_test.hpp"

/// `cpu` gives the same bits on any of them: one set of states is stored.
std::string driverUnderTest() {
    return "every system";
}

std::vector<SolverUnderTest> solversUnderTest() {
    return cpuSolvers();
}
