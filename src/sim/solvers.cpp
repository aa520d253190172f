#include "sim/solvers.hpp"

#include "cpu/cpu_solver.hpp"
#include "cpu/reference.hpp"

namespace sunder::sim {

std::span<const SolverInfo> cpuSolvers() {
    static const SolverInfo known[] = {
        {"cpu", "several cells per instruction on every core; what is at rest sleeps", false, true,
         [](const Layout& layout, const cpu::Threads& threads) {
             return MadeSolver{std::make_unique<cpu::CpuSolver>(layout.world(), threads)};
         }},
        {"reference",
         "plain loops in double precision on the CPU: slow, and what the others are tested against",
         false, false,
         [](const Layout& layout, const cpu::Threads&) {
             return MadeSolver{std::make_unique<cpu::ReferenceSolver>(layout.world())};
         }},
    };
    return known;
}

}  // namespace sunder::sim
