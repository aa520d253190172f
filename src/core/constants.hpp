#pragma once

namespace sunder::core {

#define SUNDER_REAL(name, value) inline constexpr double name = value
#define SUNDER_WHOLE(name, value) inline constexpr int name = value
#include "../../glsl/shared/constants.h"
#undef SUNDER_REAL
#undef SUNDER_WHOLE

}  // namespace sunder::core
