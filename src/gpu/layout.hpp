#pragma once
#include <glm/vec4.hpp>

#include "core/types.hpp"

namespace sunder::gpu {

using glm::ivec4;
using glm::vec4;
#include "../../glsl/shared/layout.h"

/// Texels of one NodeRecord.
inline constexpr int kNodeTexels = sizeof(NodeRecord) / sizeof(vec4);
/// Texels of one BondRecord.
inline constexpr int kBondTexels = sizeof(BondRecord) / sizeof(vec4);

inline vec4 toVec4(const core::Vec3& v, double w) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]),
            static_cast<float>(w)};
}

}  // namespace sunder::gpu
