#pragma once
#include <array>
#include <vector>

#include "core/display_mesh.hpp"
#include "core/world.hpp"

using Point = std::array<float, 3>;

/// Where it is at rest, to be compared to the bit.
Point point(const sunder::DisplayVertex&);

std::vector<sunder::DisplayVertex> verticesOf(const sunder::World&);

/// A small wall whose material has the wildest numbers that a file may hold, of every kind of
/// cluster, with or without a hole.
sunder::WorldDescription wildWall(int seed);
