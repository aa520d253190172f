#pragma once
#include "core/world.hpp"

namespace sunder::gpu {
class WorldBuffers;
}

namespace sunder::sim {

/// A world as it is laid out, once for all that simulate and draw it.
class Layout {
  public:
    /// Throws InputError for a world that cannot be laid out.
    explicit Layout(core::WorldDescription);
    virtual ~Layout() = default;
    Layout(const Layout&) = delete;
    Layout& operator=(const Layout&) = delete;

    const core::World& world() const { return world_; }
    /// The world on a GPU, for solvers there and for pictures; null where it is not (sim_gl).
    virtual const gpu::WorldBuffers* buffers() const { return nullptr; }

  private:
    core::World world_;
};

}  // namespace sunder::sim
