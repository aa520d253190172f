#pragma once
#include <cstdint>
#include <memory>

#include "gpu/world_buffers.hpp"
#include "sim/simulation.hpp"

namespace sunder::sim_gl {

/// What pictures of a simulation are drawn from, whichever solver it has: a GPU solver's own
/// buffers, or an upload. The simulation's layout must be on the GPU; it must outlive this.
class DrawnState {
  public:
    explicit DrawnState(sim::Simulation& simulation) : simulation_(simulation) {}
    /// Until the state changes.
    gpu::StateView view();

  private:
    sim::Simulation& simulation_;
    std::unique_ptr<gpu::StateUpload> upload_;  ///< once it is needed
    gpu::StateView uploaded_{};
    std::int64_t version_ = -1;  ///< of the simulation, that was uploaded
};

}  // namespace sunder::sim_gl
