#pragma once
#include <optional>

#include "core/world.hpp"
#include "scene/scene.hpp"

namespace sunder::view {

/// m, how far above the ground a camera's eye has to stay for all of its near plane to be above it,
/// too. None: the world has no ground.
std::optional<double> groundClearance(const core::World&, const scene::CameraDescription&);

/// The camera, moved back along its view as far as it takes to see all walls and objects at their
/// start in a picture of this width / height. `composed`: somebody chose what it shows of them, for
/// a picture of 16 : 9; what that leaves out may be left out.
scene::CameraDescription framed(const scene::CameraDescription&, const core::World&, double aspect,
                                bool composed);

}  // namespace sunder::view
