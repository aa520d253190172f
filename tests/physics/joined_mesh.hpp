#pragma once
#include <array>
#include <vector>

#include "core/world.hpp"

/// A whole world as one mesh of tetrahedra: the copies of a lattice point are one point.
struct JoinedMesh {
    std::vector<sunder::core::Vec3> points;  ///< m, at rest
    std::vector<bool> anchored;              ///< per point
    std::vector<double> mass;                ///< kg, per point, lumped as Sunder has it
    std::vector<std::array<int, 4>> tetrahedra;
    std::vector<int> pointOf;  ///< by node, −1 where no cell is

    /// A field given per node, per point.
    std::vector<sunder::core::Vec3> atPoints(const std::vector<sunder::core::Vec3>& field) const;
};

/// `world` has one body.
JoinedMesh joinedMesh(const sunder::core::World& world);
