#pragma once
#include <memory>
#include <span>
#include <string>

#include "core/solver.hpp"
#include "cpu/threads.hpp"
#include "sim/layout.hpp"

namespace sunder::gpu {
class GpuSolver;
}

namespace sunder::sim {

/// A solver, and the same one as what else it is.
struct MadeSolver {
    std::unique_ptr<core::Solver> solver;
    gpu::GpuSolver* onGpu = nullptr;  ///< null: its state is on the CPU
};

/// A kind of solver.
struct SolverInfo {
    std::string name;
    std::string title;  ///< one line
    bool gpu;           ///< needs the layout's buffers
    bool threaded;      ///< takes a number of threads
    /// The layout must outlive the solver. The threads are for threaded ones. Throws InputError
    /// where the device has no room for it.
    MadeSolver (*make)(const Layout&, const cpu::Threads&);
};

/// Those that need no GPU: `cpu`, `reference`.
std::span<const SolverInfo> cpuSolvers();

}  // namespace sunder::sim
