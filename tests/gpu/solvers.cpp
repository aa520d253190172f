#include "support/solver_under_test.hpp"

std::vector<SolverUnderTest> solversUnderTest() {
    return gpuSolvers();
}
