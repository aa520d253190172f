#pragma once
#include "gl/program.hpp"
#include "render/camera.hpp"
#include "render/scene_bounds.hpp"
#include "render/shadow_map.hpp"

namespace sunder {

/// Sky, and the ground where the world has one.
class Backdrop {
  public:
    Backdrop(const SceneBounds&, const gl::VertexArray& noAttributes);
    /// Draws over everything. `shadows` may be null: the ground is then in the sun everywhere.
    void draw(const Camera&, const ShadowMap* shadows) const;

  private:
    void drawGround(const Camera&, const ShadowMap* shadows) const;

    SceneBounds bounds_;
    const gl::VertexArray& noAttributes_;
    gl::Program sky_, ground_;
};

}  // namespace sunder
