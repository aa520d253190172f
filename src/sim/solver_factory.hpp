#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/world_buffers.hpp"

namespace sunder::sim {

struct SolverInfo {
    std::string name;
    std::string title;
    bool gpu;               ///< needs a GL context while it lives
    bool threaded = false;  ///< takes a number of threads
};

const std::vector<SolverInfo>& solvers();
/// Throws InputError listing the known ones, on behalf of a command line's `option`.
const SolverInfo& findSolver(std::string_view name, std::string_view option = "--solver");

/// `world` and `buffers` must outlive the solver; `buffers` may be null for a CPU solver. `threads`
/// is for threaded ones; 0: one per core.
std::unique_ptr<core::Solver> makeSolver(const SolverInfo&, const core::World& world,
                                         const gpu::WorldBuffers* buffers, int threads = 0);

/// Turns any solver's state into what a picture is drawn from: a GPU solver's own buffers, or an
/// upload.
class SolverView {
  public:
    SolverView(const core::World&, core::Solver&);
    gpu::StateView view();

  private:
    core::Solver& solver_;
    std::unique_ptr<gpu::StateUpload> upload_;
};

}  // namespace sunder::sim
