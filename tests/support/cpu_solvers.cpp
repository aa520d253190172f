#include "cpu/cpu_solver.hpp"
#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"

using namespace sunder;
using namespace sunder::core;

std::vector<SolverUnderTest> cpuSolvers() {
    return {
        {"reference",
         [](const World& world) -> std::unique_ptr<Solver> {
             return std::make_unique<cpu::ReferenceSolver>(world);
         },
         1.2e-16, false, true},
        {"cpu",
         [](const World& world) -> std::unique_ptr<Solver> {
             return std::make_unique<cpu::CpuSolver>(world);
         },
         6e-8, true, true},
    };
}
