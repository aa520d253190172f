#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"

std::vector<SolverUnderTest> solversUnderTest() {
    return {{"reference",
             [](const sunder::World& world) {
                 return std::make_unique<sunder::ReferenceSolver>(world);
             },
             1.2e-16}};
}
