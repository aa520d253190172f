#pragma once
#include "support/worlds.hpp"

/// Worlds in which cells of 0.1 m touch, and what is measured of them.

inline constexpr double kEdge = 0.1;  // m

/// Soft, elastic, undamped.
sunder::core::Material cellMaterial(double restitution, double friction);
/// Bodies of one cell of 0.1 m each; `places` are their centres.
sunder::core::WorldDescription singleCells(const std::vector<sunder::core::Vec3>& places,
                                           const sunder::core::Material& material);
/// Of a field per node, over a cell's corners.
sunder::core::Vec3 meanOf(const std::vector<sunder::core::Vec3>& field, int cell);
/// Every bond broken with probability `share`.
void breakBonds(sunder::core::State& state, double share);
/// A loose wall of 10 × 10 × 2 cells on the ground; looseState(): four fifths of its bonds broken,
/// its upper half pushed over.
sunder::core::WorldDescription looseWall();
sunder::core::State looseState(const sunder::core::World& world);
/// m: by how much spheres of cells that share no joined node overlap, at most.
double deepestOverlap(const sunder::core::World& world, const sunder::core::State& state);
