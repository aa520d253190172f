#pragma once
#include <array>
#include <vector>

#include "core/world.hpp"
#include "surface/display_mesh.hpp"

using Point = std::array<float, 3>;

/// Where it is at rest, to be compared to the bit.
Point point(const sunder::surface::DisplayVertex&);

std::vector<sunder::surface::DisplayVertex> verticesOf(const sunder::core::World&);

/// A small wall whose material has the wildest numbers that a file may hold, of every kind of
/// cluster, with or without a hole.
sunder::core::WorldDescription wildWall(int seed);
