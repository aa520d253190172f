#pragma once
#include <glm/glm.hpp>

#include "core/world.hpp"

namespace sunder::render {

/// What a picture has to have room for: the bodies at rest, the objects and chains, and air around
/// them for what breaks off.
struct SceneBounds {
    glm::vec3 low, high;  ///< m, box around all bodies and objects at the start
    glm::vec3 lowAir,
        highAir;  ///< m, the same with room for debris; ends at the ground where there is one
    bool ground = true;  ///< a floor at y = 0
    glm::vec4 room{0};   ///< m, low x and z, high x and z of the room's walls; 0: none
    float radius() const { return 0.5f * glm::length(high - low); }
};

SceneBounds sceneBounds(const core::World&);

}  // namespace sunder::render
