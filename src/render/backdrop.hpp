#pragma once
#include "gl/program.hpp"
#include "render/camera.hpp"
#include "render/scene_bounds.hpp"
#include "render/shading.hpp"

namespace sunder::render {

/// Sky, and the ground where the world has one.
class Backdrop {
  public:
    Backdrop(const SceneBounds&, const gl::VertexArray& noAttributes);
    /// Draws behind everything that is there already. Without shadows the ground is in the sun
    /// everywhere.
    void draw(const Camera&, const Shading&, bool shadowed) const;

  private:
    void drawGround(const Camera&, const Shading&, bool shadowed) const;

    SceneBounds bounds_;
    const gl::VertexArray& noAttributes_;
    gl::Program sky_, ground_;
};

}  // namespace sunder::render
