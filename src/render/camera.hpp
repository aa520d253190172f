#pragma once
#include <glm/glm.hpp>

#include "render/scene_bounds.hpp"
#include "scene/scene.hpp"

namespace sunder::render {

/// A camera's matrices, with the near and far planes that suit a scene.
struct Camera {
    glm::vec3 eye;  ///< m
    glm::mat4 view, projection;
    glm::mat4 viewProjection() const { return projection * view; }
};

/// How far the ground is drawn, m; it has faded into the haze by then.
float groundExtent(const SceneBounds&, const glm::vec3& eye);

/// How near to the eye the near plane may come, m.
float nearestPlane(const SceneBounds&);

/// `aspect` is width / height.
Camera makeCamera(const scene::CameraDescription&, float aspect, const SceneBounds&);

}  // namespace sunder::render
