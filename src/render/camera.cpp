#include "render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace sunder::render {
namespace {

float distanceToBox(const glm::vec3& p, const glm::vec3& low, const glm::vec3& high) {
    return glm::length(glm::max(glm::max(low - p, p - high), glm::vec3(0)));
}

}  // namespace

float groundExtent(const SceneBounds& bounds, const glm::vec3& eye) {
    const float away = glm::length(eye - 0.5f * (bounds.low + bounds.high));
    return 12 * (away + bounds.radius()) + 60;
}

float nearestPlane(const SceneBounds& bounds) {
    return 1e-3f * std::max(bounds.radius(), 1.f);
}

Camera makeCamera(const scene::CameraDescription& description, float aspect,
                  const SceneBounds& bounds) {
    Camera camera;
    camera.eye =
        glm::vec3(description.position[0], description.position[1], description.position[2]);
    const glm::vec3 target(description.target[0], description.target[1], description.target[2]);
    glm::vec3 forward = target - camera.eye;
    const float length = glm::length(forward);
    forward = length > 0 ? forward / length : glm::vec3(0, 0, -1);
    // Straight up or down leaves "up" open: the picture's top is then -z, as on a map.
    const glm::vec3 up = std::abs(forward.y) > 0.9999f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    camera.view = glm::lookAt(camera.eye, camera.eye + forward, up);

    // As far out as what must be seen allows: depth is sharpest just behind the near plane.
    float near = 0.5f * distanceToBox(camera.eye, bounds.lowAir, bounds.highAir);
    float far =
        glm::length(camera.eye - 0.5f * (bounds.low + bounds.high)) + 4 * bounds.radius() + 10;
    const float fieldOfView = glm::radians(static_cast<float>(description.fieldOfView));
    if (bounds.ground) {
        // A wide picture's near plane reaches down to the ground from further up.
        const float share = std::min(0.4f, 0.9f * std::cos(0.5f * fieldOfView));
        near = std::min(near, share * std::abs(camera.eye.y));
        far = std::max(far, 1.5f * groundExtent(bounds, camera.eye));
    }
    near = std::max(near, nearestPlane(bounds));
    camera.projection = glm::perspective(fieldOfView, aspect, near, far);
    return camera;
}

}  // namespace sunder::render
