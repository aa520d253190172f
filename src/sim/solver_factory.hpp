#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/solver.hpp"
#include "gpu/world_buffers.hpp"
#include "sim/layout.hpp"

namespace sunder::sim {

struct SolverInfo {
    std::string name;
    std::string title;
    bool gpu;               ///< needs Layout::upload()
    bool threaded = false;  ///< takes a number of threads
};

const std::vector<SolverInfo>& solvers();
/// Throws InputError listing the known ones, on behalf of a command line's `option`.
const SolverInfo& findSolver(std::string_view name, std::string_view option = "--solver");

/// A solver, and the same one as what else it can do.
struct MadeSolver {
    std::unique_ptr<core::Solver> solver;
    gpu::GpuSolver* onGpu = nullptr;  ///< null: its state is on the CPU
};

/// The layout must outlive the solver. `threads` is for threaded ones; 0: one per core. Throws
/// InputError where the device has no room for it.
MadeSolver makeSolver(const SolverInfo&, const Layout&, int threads = 0);

}  // namespace sunder::sim
