#pragma once
#include <glm/glm.hpp>

#include "gl/program.hpp"
#include "gpu/world_buffers.hpp"
#include "surface/display_mesh.hpp"

namespace sunder::render {

/// A display mesh on the GPU.
class DisplayBuffers {
  public:
    explicit DisplayBuffers(const surface::DisplayMesh&);

    enum class Part { Opaque, Transparent };
    bool empty(Part part) const { return count(part) == 0; }
    void draw(Part) const;
    /// Every vertex once, as a point.
    void drawVertices() const;

  private:
    std::size_t count(Part part) const {
        return part == Part::Opaque ? opaqueIndices_ : indices_ - opaqueIndices_;
    }
    std::size_t vertices_, indices_, opaqueIndices_;
    gl::Buffer vertexBuffer_, indexBuffer_;
    gl::VertexArray vertexArray_;
};

/// Draws the display mesh (thesis, figure 8.1) of all bodies; the vertex shader moves it.
class DisplayPass {
  public:
    enum class Output {
        Depth,  ///< for the shadow map
        Shaded,
        Lines,        ///< one colour, for GL_LINE polygons
        Veil,         ///< of transparent materials, for the shadow map
        Transparent,  ///< inside Transparency::draw()
        Captured,     ///< of every vertex `position` (m), `normal` and `place` (m), nine floats
    };
    DisplayPass(Output, const gpu::WorldBuffers&, const DisplayBuffers&);

    /// In use after this; set further uniforms of it before draw().
    const gl::Program& begin() const;
    void draw(const gpu::StateView&, const glm::mat4& viewProjection, DisplayBuffers::Part) const;
    /// Every vertex once, as a point.
    void drawVertices(const gpu::StateView&) const;

  private:
    const gpu::WorldBuffers& buffers_;
    const DisplayBuffers& mesh_;
    gl::Program program_;
};

}  // namespace sunder::render
