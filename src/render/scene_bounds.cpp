#include "render/scene_bounds.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace sunder::render {

using namespace core;

namespace {

struct Corners {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
    Vec3 high = -low;
    void include(const Vec3& a, const Vec3& b) {
        low = low.cwiseMin(a);
        high = high.cwiseMax(b);
    }
    void include(const Vec3& centre, double reach) {
        include(centre - Vec3::Constant(reach), centre + Vec3::Constant(reach));
    }
};

/// Where objects are at first, and where they are thrown from. What comes from further away than
/// three times `wall` (m) is on its way for a moment only: not worth a coarser shadow map.
void includeObjects(const World& world, double wall, Corners& box) {
    const Corners bodies = box;
    for (std::size_t i = 0; i < world.objects().size(); ++i) {
        const Object& object = world.objects()[i];
        const std::optional<Vec3>& position = world.description().objects[i].position;
        if (position) box.include(*position, object.reach());
        if (object.chain > 0) box.include(object.hungFrom, 0);
    }
    const Vec3 away = Vec3::Constant(3 * wall);
    for (const Throw& thrown : world.throws())
        box.include(thrown.state.position.cwiseMax(bodies.low - away).cwiseMin(bodies.high + away),
                    world.objects()[thrown.object].reach());
}

}  // namespace

SceneBounds sceneBounds(const World& world) {
    Corners box;
    double tallest = 0;
    for (const Body& body : world.bodies()) {
        const Box bounds = body.bounds();
        box.include(bounds.low, bounds.high);
        tallest = std::max(tallest, body.size().maxCoeff());
    }
    includeObjects(world, tallest, box);
    // Debris of a blow lands within about a wall's height; more would only cost the shadow map its
    // sharpness.
    const Vec3 air = Vec3::Constant(0.6 * tallest);
    SceneBounds bounds;
    const auto toGlm = [](const Vec3& v) { return glm::vec3(v[0], v[1], v[2]); };
    bounds.low = toGlm(box.low);
    bounds.high = toGlm(box.high);
    bounds.lowAir = toGlm(box.low - air);
    bounds.highAir = toGlm(box.high + air);
    bounds.ground = world.description().ground;
    if (const auto& room = world.description().room)
        bounds.room = glm::vec4(room->x[0], room->z[0], room->x[1], room->z[1]);
    if (bounds.ground) bounds.lowAir.y = std::min(0.f, bounds.low.y);
    return bounds;
}

}  // namespace sunder::render
