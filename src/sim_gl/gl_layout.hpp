#pragma once
#include <optional>

#include "gpu/world_buffers.hpp"
#include "sim/layout.hpp"

namespace sunder::sim_gl {

/// A layout that can be on the GPU as well.
class GlLayout : public sim::Layout {
  public:
    using sim::Layout::Layout;
    /// Puts it there. A GL context must be current, and must be whenever any of its solvers or
    /// pictures is used, until all of them and this are gone. Throws InputError for a world that is
    /// too large for the device.
    void upload() { buffers_.emplace(world()); }
    const gpu::WorldBuffers* buffers() const override { return buffers_ ? &*buffers_ : nullptr; }

  private:
    std::optional<gpu::WorldBuffers> buffers_;
};

}  // namespace sunder::sim_gl
