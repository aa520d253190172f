#pragma once
#include "scene/scene.hpp"

namespace sunder::app {

/// The scene's world as it stands before anything happens (cpu/settle.hpp). A bar on a terminal
/// while that takes long, and a note on stderr where no state of rest was found.
core::State startOf(const scene::Scene& scene, const core::World& world);

}  // namespace sunder::app
