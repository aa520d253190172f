#pragma once
#include <array>
#include <vector>

#include "core/world.hpp"

namespace sunder::cpu {

/// Pairs of bodies with cells that have come to overlap, by more than `depth` of their shortest
/// edge and by more than they did at rest; the boxes around deformed cells stand for them.
std::vector<std::array<int, 2>> collidingBodies(const core::World&, const core::State&,
                                                double depth);

}  // namespace sunder::cpu
