#pragma once
#include <cstddef>

#include "core/limits.hpp"

namespace sunder::scene {

// What a file may ask for, beside what a world may have (core/limits.hpp).
inline constexpr std::size_t kMaxTitle = 200;      ///< characters
inline constexpr std::size_t kMaxMaterials = 256;  ///< of a scene's own

}  // namespace sunder::scene
