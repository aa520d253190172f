#pragma once
#include <array>

#include "gpu/feedback.hpp"

namespace sunder::gpu {

/// Damage of bonds and what follows from it: which nodes are joined, and the masses of their
/// groups.
class BondPass {
  public:
    /// `textureColumns`: of the texture with stresses.
    BondPass(const core::World&, int textureColumns);

    const BondBuffer& bonds() const { return bonds_[current_].bonds; }
    /// Texture buffer, RGBA32F, SUNDER_LINK_TEXELS per cell (LinkRecord).
    const gl::Texture& links() const { return linkTexture_; }
    const gl::Buffer& linkBuffer() const { return linkBuffer_; }

    /// Advances damage by one fracture interval from the stresses of the last element update, then
    /// the links. Needs bindWorld() and ReleasedBodies::bind().
    void update(const Feedback&);
    /// Sets the damage and recomputes the links. Needs the same.
    void write(const core::State&, const Feedback&);
    /// After anchors let go. Needs bindWorld() and ReleasedBodies::bind().
    void updateLinks(const Feedback&);

  private:
    struct Side {
        BondBuffer bonds;
        gl::VertexArray attributes;
    };

    int cellCount_;
    gl::Program fractureProgram_, linkProgram_;
    gl::Buffer linkBuffer_;
    gl::Texture linkTexture_;
    std::array<Side, 2> bonds_;  ///< [current_] is read, the other written
    int current_ = 0;
};

}  // namespace sunder::gpu
