#pragma once
#include "core/world.hpp"

/// Objects to test with, and a world for them.

/// A sphere; radius: m; mass: kg; velocity: m/s. Without drag.
sunder::ObjectDescription ball(double radius, double mass, const sunder::Vec3& position,
                               const sunder::Vec3& velocity);
/// The same in another shape.
sunder::ObjectDescription shaped(sunder::ObjectShape shape, const sunder::Vec3& halfSize,
                                 double mass, const sunder::Vec3& position,
                                 const sunder::Vec3& velocity);
/// A far-off anchored cell: every world needs a body.
sunder::WorldDescription objectsOnly();
