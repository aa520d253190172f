#pragma once
#include "gl/program.hpp"
#include "gpu/world_buffers.hpp"

namespace sunder::render {

/// What the vertex shaders of walls read of a world and its state, on its texture units.

/// Once for a program.
void prepareWallState(const gl::Program&);
/// For the program in use, before it draws.
void bindWallState(const gl::Program&, const gpu::WorldBuffers&, const gpu::StateView&);

}  // namespace sunder::render
