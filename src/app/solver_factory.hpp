#pragma once
#include <memory>
#include <string>
#include <vector>

#include "gpu/world_buffers.hpp"

namespace sunder::app {

struct SolverInfo {
    std::string name;
    std::string title;
    bool gpu;  ///< needs a GL context while it lives
};

const std::vector<SolverInfo>& solvers();
const SolverInfo& findSolver(
    const std::string& name);  ///< throws InputError listing the known ones

/// `world` and `buffers` must outlive the solver; `buffers` may be null for a CPU solver.
std::unique_ptr<Solver> makeSolver(const SolverInfo&, const World& world,
                                   const gpu::WorldBuffers* buffers);

/// Turns any solver's state into what a picture is drawn from: a GPU solver's own buffers, or an
/// upload.
class SolverView {
  public:
    SolverView(const World&, Solver&);
    gpu::StateView view();

  private:
    Solver& solver_;
    std::unique_ptr<gpu::StateUpload> upload_;
};

}  // namespace sunder::app
