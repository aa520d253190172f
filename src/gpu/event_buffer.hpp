#pragma once
#include "gpu/world_buffers.hpp"

namespace sunder::gpu {

/// The world's events on the GPU (EventRecord).
class EventBuffer {
  public:
    explicit EventBuffer(const core::World&);
    /// Texture buffer, RGBA32F, SUNDER_EVENT_TEXELS per event, sorted by body.
    const gl::Texture& texture() const { return texture_; }
    /// Event times count steps from `step`, the first of this frame: single precision stays exact
    /// however long the world has run. Returns whether any event acts during the next `steps`.
    bool write(std::int64_t step, int steps);

  private:
    const core::World& world_;
    bool stale_ = true;  ///< the buffer holds what must not act: nothing yet, or past events
    gl::Buffer buffer_;
    gl::Texture texture_;
};

}  // namespace sunder::gpu
