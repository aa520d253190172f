#pragma once
#include <glm/glm.hpp>

#include "gl/program.hpp"
#include "gpu/world_buffers.hpp"

namespace sunder::render {

/// Draws all bodies' cells as point primitives, one per face, which a geometry shader turns into
/// faces (thesis, figure 6.6).
class CellPass {
  public:
    enum class Output {
        Depth,  ///< for the shadow map, of opaque materials
        Shaded,
        Lines,        ///< one colour, for GL_LINE polygons
        Veil,         ///< for the shadow map, of transparent materials
        Transparent,  ///< inside Transparency::draw()
    };
    CellPass(Output, const gpu::WorldBuffers&, const gl::VertexArray& noAttributes);

    /// In use after this; set further uniforms of it before draw().
    const gl::Program& begin() const;
    void draw(const gpu::StateView&, const glm::mat4& viewProjection) const;

  private:
    const gpu::WorldBuffers& buffers_;
    const gl::VertexArray& noAttributes_;
    gl::Program program_;
};

}  // namespace sunder::render
