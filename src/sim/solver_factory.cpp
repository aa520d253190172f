#include "sim/solver_factory.hpp"

#include <cassert>
#include <utility>

#include "balance/balanced_solver.hpp"
#include "cpu/cpu_solver.hpp"
#include "cpu/reference.hpp"
#include "gpu/gather.hpp"
#include "gpu/scatter.hpp"

namespace sunder::sim {

using namespace core;

const std::vector<SolverInfo>& solvers() {
    static const std::vector<SolverInfo> known = {
        {"gather", "GPU: a fragment per cell and per node, no blending (GL 4.1; the default)",
         true},
        {"scatter", "GPU, the thesis's method: additive blending and transform feedback (GL 4.1)",
         true},
        {"auto", "shares bodies out between cpu and gather by measured cost, both at once", true,
         true},
        {"cpu", "several cells per instruction on every core; what is at rest sleeps", false, true},
        {"reference",
         "plain loops in double precision on the CPU: slow, and what the others are tested against",
         false},
    };
    return known;
}

const SolverInfo& findSolver(std::string_view name, std::string_view option) {
    std::string names;
    for (const SolverInfo& solver : solvers()) {
        if (solver.name == name) return solver;
        names += (names.empty() ? "" : ", ") + solver.name;
    }
    throw InputError(std::string(option) + ": there is no solver '" + std::string(name) +
                     "'; known: " + names);
}

namespace {

template <class Made>
MadeSolver onGpu(std::unique_ptr<Made> solver) {
    gpu::GpuSolver* const same = solver.get();
    return {std::move(solver), same};
}

}  // namespace

MadeSolver makeSolver(const SolverInfo& info, const Layout& layout, int threads) {
    const World& world = layout.world();
    assert(!info.gpu || layout.buffers());
    if (info.name == "gather")
        return onGpu(std::make_unique<gpu::GatherSolver>(world, *layout.buffers()));
    if (info.name == "scatter")
        return onGpu(std::make_unique<gpu::ScatterSolver>(world, *layout.buffers()));
    if (info.name == "auto")
        return onGpu(std::make_unique<balance::BalancedSolver>(world, *layout.buffers(), threads));
    if (info.name == "cpu") return {std::make_unique<cpu::CpuSolver>(world, threads)};
    return {std::make_unique<cpu::ReferenceSolver>(world)};
}

}  // namespace sunder::sim
