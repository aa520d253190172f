#include "sim_gl/solvers.hpp"

#include <cassert>
#include <memory>
#include <string>
#include <utility>

#include "balance/balanced_solver.hpp"
#include "gpu/gather.hpp"
#include "gpu/scatter.hpp"

namespace sunder::sim_gl {

using namespace core;

namespace {

/// arguments: after world and buffers.
template <class Made, class... Arguments>
sim::MadeSolver make(const sim::Layout& layout, const Arguments&... arguments) {
    assert(layout.buffers());
    auto solver = std::make_unique<Made>(layout.world(), *layout.buffers(), arguments...);
    gpu::GpuSolver* const same = solver.get();
    return {std::move(solver), same};
}

}  // namespace

const std::vector<sim::SolverInfo>& solvers() {
    static const std::vector<sim::SolverInfo> known = [] {
        std::vector<sim::SolverInfo> all = {
            {"gather", "GPU: a fragment per cell and per node, no blending (GL 4.1; the default)",
             true, false,
             [](const sim::Layout& layout, const cpu::Threads&) {
                 return make<gpu::GatherSolver>(layout);
             }},
            {"compute", "GPU: gather's passes as compute shaders (GL 4.3)", true, false,
             [](const sim::Layout& layout, const cpu::Threads&) {
                 return make<gpu::ComputeSolver>(layout);
             }},
            {"scatter",
             "GPU, the thesis's method: additive blending and transform feedback (GL 4.1)", true,
             false,
             [](const sim::Layout& layout, const cpu::Threads&) {
                 return make<gpu::ScatterSolver>(layout);
             }},
            {"auto", "shares bodies out between cpu and gather by measured cost, both at once",
             true, true,
             [](const sim::Layout& layout, const cpu::Threads& threads) {
                 return make<balance::BalancedSolver>(layout, threads);
             }},
        };
        all.insert(all.end(), sim::cpuSolvers().begin(), sim::cpuSolvers().end());
        return all;
    }();
    return known;
}

const sim::SolverInfo& findSolver(std::string_view name, std::string_view option) {
    std::string names;
    for (const sim::SolverInfo& solver : solvers()) {
        if (solver.name == name) return solver;
        names += (names.empty() ? "" : ", ") + solver.name;
    }
    throw InputError(std::string(option) + ": there is no solver '" + std::string(name) +
                     "'; known: " + names);
}

}  // namespace sunder::sim_gl
