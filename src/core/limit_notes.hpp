#pragma once
#include <string>
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

/// One sentence per material whose stiffness the step does not carry; never silent.
std::vector<std::string> limitNotes(const World&);

}  // namespace sunder::core
