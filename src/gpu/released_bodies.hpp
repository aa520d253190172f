#pragma once
#include "core/body_book.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {

/// Which bodies' anchors have let go, for glsl/physics/joints.glsl.
class ReleasedBodies {
  public:
    /// None.
    explicit ReleasedBodies(const core::World& world);
    /// As a solver's book has it. The links of bodies that changed are to be worked out anew.
    void write(const core::BodyBook& book);
    void bind() const { gl::bindTexture(kReleased, GL_TEXTURE_BUFFER, texture_); }

  private:
    std::size_t bodies_;
    gl::Buffer buffer_;  ///< per body 1 or 0
    gl::Texture texture_;
};

}  // namespace sunder::gpu
