#pragma once
#include <optional>
#include <vector>

#include "surface/display_mesh.hpp"

namespace sunder::surface {

/// What a ray meets first.
struct Spot {
    core::Vec3 place{0, 0, 0};   ///< m
    double distance = 0;         ///< m from the ray's origin
    int cell = -1;               ///< whose section it is, or
    int object = -1;             ///< which object
    core::Vec3 normal{0, 0, 0};  ///< of length 1, outwards
    core::Vec3 rest{0, 0, 0};    ///< m, of a cell: where that place is at rest
};

/// Finds what a ray meets, such as the one under a mouse, on the mesh that is seen as it is
/// deformed now. On the CPU: only sections near the ray are moved.
class Picker {
  public:
    /// Both must outlive it.
    Picker(const core::World&, const DisplayMesh&);

    /// `direction` has length 1.
    std::optional<Spot> pick(const core::State&, const core::Vec3& origin,
                             const core::Vec3& direction) const;

  private:
    void pickCell(const core::State&, int cell, const core::Vec3& origin,
                  const core::Vec3& direction, std::optional<Spot>& nearest) const;
    void pickObjects(const core::State&, const core::Vec3& origin, const core::Vec3& direction,
                     std::optional<Spot>& nearest) const;

    const core::World& world_;
    const DisplayMesh& mesh_;
    /// Triangles of a cell: first indices of them in the mesh, from start_[cell] to
    /// start_[cell + 1].
    std::vector<std::uint32_t> start_, triangles_;
    /// How far a cell's section reaches from the cell's centre, over how far its corners do.
    std::vector<float> reach_;
};

}  // namespace sunder::surface
