#pragma once
#include "core/world.hpp"

/// Objects to test with, and a world for them.

/// A sphere; radius: m; mass: kg; velocity: m/s. Without drag.
sunder::core::ObjectDescription ball(double radius, double mass, const sunder::core::Vec3& position,
                                     const sunder::core::Vec3& velocity);
/// The same in another shape.
sunder::core::ObjectDescription shaped(sunder::core::ObjectShape shape,
                                       const sunder::core::Vec3& halfSize, double mass,
                                       const sunder::core::Vec3& position,
                                       const sunder::core::Vec3& velocity);
/// A far-off anchored cell: every world needs a body.
sunder::core::WorldDescription objectsOnly();
