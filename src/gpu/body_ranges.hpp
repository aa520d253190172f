#pragma once
#include <vector>

#include "core/world.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// The cells of a body, a texel each.
TexelRange cellsOf(const core::World& world, int body);
/// Of several bodies, ascending; those that are neighbours in the numbering become one range.
std::vector<TexelRange> rangesOf(const core::World& world, const std::vector<int>& bodies);

}  // namespace sunder::gpu
