#include "render/scene_bounds.hpp"

#include <algorithm>
#include <limits>

namespace sunder {

SceneBounds sceneBounds(const World& world) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
    Vec3 high = -low;
    double tallest = 0;
    for (const Body& body : world.bodies()) {
        const Vec3 size = body.cellSize.cwiseProduct(body.cells.cast<double>());
        low = low.cwiseMin(body.origin);
        high = high.cwiseMax(body.origin + size);
        tallest = std::max(tallest, size.maxCoeff());
    }
    const Vec3 thrownLow = low - Vec3::Constant(3 * tallest);
    const Vec3 thrownHigh = high + Vec3::Constant(3 * tallest);
    const auto include = [&](const Vec3& centre, double reach) {
        low = low.cwiseMin(centre - Vec3::Constant(reach));
        high = high.cwiseMax(centre + Vec3::Constant(reach));
    };
    const WorldDescription& description = world.description();
    for (std::size_t i = 0; i < world.objects().size(); ++i) {
        const Object& object = world.objects()[i];
        if (description.objects[i].position)
            include(*description.objects[i].position, object.reach());
        if (object.chain > 0) include(object.hungFrom, 0);
    }
    // What comes from far away is on its way for a moment only: not worth a coarser shadow map.
    for (const Throw& thrown : world.throws())
        include(thrown.state.position.cwiseMax(thrownLow).cwiseMin(thrownHigh),
                world.objects()[thrown.object].reach());
    // Debris of a blow lands within about a wall's height; more would only cost the shadow map its
    // sharpness.
    const Vec3 air = Vec3::Constant(0.6 * tallest);
    SceneBounds bounds;
    const auto toGlm = [](const Vec3& v) { return glm::vec3(v[0], v[1], v[2]); };
    bounds.low = toGlm(low);
    bounds.high = toGlm(high);
    bounds.lowAir = toGlm(low - air);
    bounds.highAir = toGlm(high + air);
    bounds.ground = description.ground;
    if (const auto& room = description.room)
        bounds.room = glm::vec4(room->x[0], room->z[0], room->x[1], room->z[1]);
    if (bounds.ground) bounds.lowAir.y = std::min(0.f, bounds.low.y);
    return bounds;
}

}  // namespace sunder
