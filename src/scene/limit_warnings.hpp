#pragma once
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace sunder {

/// One sentence per material whose stiffness the step does not carry; never silent.
std::vector<std::string> limitWarnings(const Scene&, const World&);

}  // namespace sunder
