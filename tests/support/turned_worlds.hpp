#pragma once
#include "core/world.hpp"

/// The same world, turned as a whole about the world's origin: bodies, objects, what pushes and
/// throws them, and gravity. Ground and room stay, so there must be none, or the turn must be one
/// about y and there no room.
sunder::core::WorldDescription turnedWorld(sunder::core::WorldDescription,
                                           const sunder::core::Mat3& turn);

/// Likewise, of what is in it; events in `pushes` are left alone.
sunder::core::State turnedState(sunder::core::State, const sunder::core::Mat3& turn);
