#pragma once
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace sunder::scene {

/// One sentence per material whose stiffness the step does not carry; never silent.
std::vector<std::string> limitWarnings(const Scene&, const core::World&);

}  // namespace sunder::scene
