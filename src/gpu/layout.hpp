#pragma once
#include <glm/vec4.hpp>

namespace sunder::gpu {

using glm::uvec4;
using glm::vec4;
#include "../../glsl/shared/layout.h"

}  // namespace sunder::gpu
