#include "sim/solver_factory.hpp"

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

std::unique_ptr<Solver> makeSolver(const SolverInfo& info, const World& world,
                                   const gpu::WorldBuffers* buffers, int threads) {
    if (info.name == "gather") return std::make_unique<gpu::GatherSolver>(world, *buffers);
    if (info.name == "scatter") return std::make_unique<gpu::ScatterSolver>(world, *buffers);
    if (info.name == "auto")
        return std::make_unique<balance::BalancedSolver>(world, *buffers, threads);
    if (info.name == "cpu") return std::make_unique<cpu::CpuSolver>(world, threads);
    return std::make_unique<cpu::ReferenceSolver>(world);
}

SolverView::SolverView(const World& world, Solver& solver) : solver_(solver) {
    if (!dynamic_cast<const gpu::GpuSolver*>(&solver))
        upload_ = std::make_unique<gpu::StateUpload>(world);
}

gpu::StateView SolverView::view() {
    if (upload_) return upload_->upload(solver_.state());
    return dynamic_cast<gpu::GpuSolver&>(solver_).view();
}

}  // namespace sunder::sim
