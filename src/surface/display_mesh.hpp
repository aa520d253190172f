#pragma once
#include <cstdint>
#include <vector>

#include "surface/display_lattice.hpp"

namespace sunder::surface {

#include "../../glsl/shared/display_vertex.h"

/// A vertex of the mesh that is seen, as the GPU reads it: 24 bytes.
struct DisplayVertex {
    Eigen::Vector3f rest;  ///< m, world
    std::uint32_t cell;    ///< whose section it belongs to
    std::uint32_t code;    ///< SUNDER_DISPLAY_… of glsl/shared/display_vertex.h
    /// Of an inner face: the cell that owns the bond through it. Nothing sees the face while that
    /// holds, so it is the first thing to ask.
    std::uint32_t bondOwner;
};
static_assert(sizeof(DisplayVertex) == 24);

/// 288 MB.
inline constexpr std::int64_t kMostDisplayVertices = 12'000'000;

/// What a player sees of a world (thesis, chapter 8): for every cell one *section*, a closed volume
/// of triangles whose torn faces interlock with its neighbours' (DisplayLattice). Made once; while
/// time runs the vertex shader (glsl/draw/display.vert) moves it by the tetrahedra that its
/// vertices are bound to.
class DisplayMesh {
  public:
    /// Where there would be more than `mostVertices`, cells get fewer edge points. Throws
    /// InputError where even without any there would be more.
    explicit DisplayMesh(const core::World&, std::int64_t mostVertices = kMostDisplayVertices);

    const std::vector<DisplayVertex>& vertices() const { return vertices_; }
    /// Three per triangle, anticlockwise seen from outside the section. Opaque cells' come first.
    const std::vector<std::uint32_t>& indices() const { return indices_; }
    /// How many of indices() belong to opaque cells.
    std::size_t opaqueIndices() const { return opaqueIndices_; }
    /// Whether some cells have fewer edge points than their materials ask for.
    bool simplified() const { return simplified_; }

  private:
    void addBody(const core::World&, int body, int mostSegments,
                 std::vector<std::uint32_t>& transparent);

    std::vector<DisplayVertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::size_t opaqueIndices_ = 0;
    bool simplified_ = false;
};

/// Where a vertex is, m, world, in double precision: what the vertex shader computes, for tests.
///
/// A vertex between cells is shared by those that still hang together around it: all of them bind
/// it to the same tetrahedron, of the cell that it lies in if that is one of them, so there is no
/// seam. Cells that have come apart bind it each to one of their own, and draw back from each other
/// by SUNDER_DISPLAY_GAP of a cell, so that a crack is seen before it opens.
core::Vec3 displayedPosition(const core::World&, const core::State&, const DisplayVertex&);

/// Whether a vertex belongs to a face that nothing can see: its bond holds.
bool displayHidden(const core::State&, const DisplayVertex&);

}  // namespace sunder::surface
