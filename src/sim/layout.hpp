#pragma once
#include <optional>

#include "gpu/world_buffers.hpp"

namespace sunder::sim {

/// A world as it is laid out, once for all that simulate and draw it.
class Layout {
  public:
    /// Throws InputError for a world that cannot be laid out.
    explicit Layout(core::WorldDescription);
    /// Puts it on the GPU, too, for solvers there and for pictures. A GL context must be current,
    /// and must be whenever any of them is used, until all of them and this are gone. Throws
    /// InputError for a world that is too large for the device.
    void upload();

    const core::World& world() const { return world_; }
    /// Null before upload().
    const gpu::WorldBuffers* buffers() const { return buffers_ ? &*buffers_ : nullptr; }

  private:
    core::World world_;
    std::optional<gpu::WorldBuffers> buffers_;
};

}  // namespace sunder::sim
