#pragma once
#include "gpu/world_buffers.hpp"

namespace sunder::gpu {

/// The world's events on the GPU (EventRecord).
class EventBuffer {
  public:
    /// The world must outlive it.
    explicit EventBuffer(const core::World&);
    core::EventSchedule& schedule() { return schedule_; }
    const core::EventSchedule& schedule() const { return schedule_; }

    /// Texture buffer, RGBA32F, for glsl/physics/events.glsl. Another one may come with each
    /// write().
    const gl::Texture& texture() const { return texture_; }
    /// Event times count steps from `step`, the first of this frame: single precision stays exact
    /// however long the world has run. Returns whether any event acts during the next `steps`.
    bool write(std::int64_t step, int steps);

  private:
    void reserve(std::size_t texels);
    void upload(const std::vector<std::vector<const core::Event*>>& active, std::int64_t step);

    core::EventSchedule schedule_;
    std::size_t bodies_;
    bool stale_ = true;  ///< the buffer holds what must not act: nothing yet, or past events
    gl::Buffer buffer_;
    gl::Texture texture_;
};

}  // namespace sunder::gpu
