#pragma once
#include "gl/program.hpp"
#include "gpu/world_buffers.hpp"

namespace sunder::gpu {

/// What the vertex shaders of walls read of a world and its state, on this many texture units.
inline constexpr int kWallUnits = 5;

/// Once for a program. firstUnit: of those units.
void prepareWallState(const gl::Program&, int firstUnit);
/// For the program in use, before it draws.
void bindWallState(const gl::Program&, const WorldBuffers&, const StateView&, int firstUnit);

}  // namespace sunder::gpu
