#pragma once
#include <cstdint>
#include <vector>

#include "gpu/feedback.hpp"
#include "surface/display_mesh.hpp"

namespace sunder::sim_gl {

/// The mesh that is seen, deformed into a vertex buffer: for hosts that draw it with shaders of
/// their own, which need to know nothing of cells and bonds. Transform feedback of the vertex
/// shader that Sunder draws with (glsl/draw/display.vert).
class DeformedMesh {
  public:
    /// As transform feedback writes it.
    struct Vertex {
        float position[3];  ///< m, world
        float normal[3];    ///< of length 1
        float tangent[4];   ///< of length 1; sign of the bitangent
    };
    struct RestVertex {
        float place[3];     ///< m, from the body's origin
        float texCoord[2];  ///< m
        std::int32_t material, body, cell, inside, reserved;
    };
    struct Range {
        int material;
        bool inside, transparent;
        int first, count;  ///< indices
    };
    /// Locations of the attributes of vertexArray().
    enum Location {
        kPosition,
        kNormal,
        kTangent,
        kPlace,
        kTexCoord,
        kMaterial,
        kBody,
        kCell,
        kInside,
        kPiece
    };

    /// pieces: whether setPieces() will be called. Both must outlive it.
    DeformedMesh(const core::World&, const gpu::WorldBuffers&, bool pieces);

    /// Vertices of one body.
    struct Part {
        int body, first, count;
    };
    Part part(int body) const {
        return {body, bodyFirst_[body], bodyFirst_[body + 1] - bodyFirst_[body]};
    }
    /// Deforms those of these bodies, which ascend.
    void update(const gpu::StateView&, const std::vector<int>& bodies) const;
    /// The number of each cell's piece, to be an attribute of its vertices.
    void setPieces(const std::vector<int>& ofCell);

    int vertices() const { return bodyFirst_.back(); }
    const std::vector<Range>& ranges() const { return ranges_; }  ///< opaque ones first
    GLuint vertexArray() const { return drawnArray_.id(); }
    /// What the shader reads, with the same indices.
    GLuint boundArray() const { return boundArray_.id(); }
    GLuint vertexBuffer() const { return deformed_.id(); }
    GLuint restBuffer() const { return rest_.id(); }
    GLuint pieceBuffer() const { return pieces_.id(); }  ///< 0: none
    GLuint indexBuffer() const { return indices_.id(); }

  private:
    void makeRanges(const core::World&, const surface::DisplayMesh&);
    void makeArrays();

    const gpu::WorldBuffers& buffers_;
    std::vector<int> bodyFirst_;         ///< first vertex of each body, and how many there are
    std::vector<std::uint32_t> cellOf_;  ///< of each vertex, where there are pieces
    std::vector<Range> ranges_;
    gl::Program program_;
    gpu::Feedback feedback_;
    gl::Buffer bound_;  ///< surface::DisplayVertex, which the shader reads
    gl::Buffer rest_, deformed_, indices_, pieces_;
    gl::VertexArray boundArray_, drawnArray_;
};

}  // namespace sunder::sim_gl
