#pragma once
#include <vector>

#include "core/world.hpp"

namespace sunder::surface {

/// The lattice of the mesh that is seen (thesis, chapter 8), of one body: the cells' lattice, each
/// cell divided into segments, and every point moved so that the pieces of a broken wall look torn.
/// A cell's share of it is its *section*. Because neighbouring sections take their points from
/// here, they interlock: no gap, no overlap, whatever the parameters.
///
/// How points move:
/// - Corners of cells move by `rand_display_section_…`, at random; where clusters meet, onto their
///   boundary, so that a brick or a chunk of concrete has straight sides and not the cells' stairs.
/// - Points between, on the faces through which cells are joined, zig-zag across the face by
///   `…_edge_amplitude`. `…_edge_frequency` of them come on a length of `avg_display_section_…`:
///   on each edge of a cell when that is its size, as in the thesis.
/// - Points on the body's outside stay on it, and its edges stay straight.
///
/// No section folds over itself: amplitudes end at 0.45 of a cell, and displacements that turn a
/// piece of the lattice inside out are reduced until none is.
class DisplayLattice {
  public:
    DisplayLattice(const core::World&, int body, int mostSegments);

    /// Segments of a cell along x, y, z.
    const core::IVec3& segments() const { return segments_; }
    /// Points along x, y, z.
    const core::IVec3& size() const { return size_; }
    int index(const core::IVec3& p) const { return p[0] + size_[0] * (p[1] + size_[1] * p[2]); }
    /// m, from the body's origin, at rest.
    const core::Vec3& position(const core::IVec3& p) const { return positions_[index(p)]; }

    /// Whether the point lies on the outside of the body's cells (beyond it there is none), for a
    /// face with normal `axis`. `p` must lie on a plane between cells of that axis.
    bool outside(const core::IVec3& p, int axis) const;
    /// Whether the bond through the + face of a cell (lattice coordinates) lies on the boundary of
    /// two clusters.
    bool clusterBoundary(const core::IVec3& cell, int axis) const;

  private:
    struct Maker;
    core::IVec3 segments_, size_;
    core::IVec3 cells_;
    std::vector<core::Vec3> positions_;
    std::vector<std::uint8_t> outside_;   ///< bit per axis, per point
    std::vector<std::uint8_t> boundary_;  ///< bit per axis, per cell
};

/// Segments of a cell along x, y, z that the materials of its body ask for.
core::IVec3 displaySegments(const core::World&, int body);

}  // namespace sunder::surface
