#include "view/framing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/camera.hpp"
#include "view/orbit_camera.hpp"

namespace sunder::view {

using namespace core;

namespace {

using Corners = std::array<Vec3, 8>;

constexpr double kComposedAspect = 16.0 / 9;
constexpr double kMargin = 0.03;  // of half the picture, around what has to be seen

Corners cornersOf(const Vec3& centre, const Mat3& axes, const Vec3& halfSize) {
    Corners corners;
    for (int i = 0; i < 8; ++i) {
        const Vec3 side(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        corners[i] = centre + axes * halfSize.cwiseProduct(side);
    }
    return corners;
}

/// Of bodies, and of objects that are there from the start.
std::vector<Corners> boxesAtStart(const World& world) {
    std::vector<Corners> boxes;
    for (const Body& body : world.bodies()) {
        const Vec3 half = 0.5 * body.size();
        boxes.push_back(cornersOf(body.inWorld(half), body.axes, half));
    }
    for (const ObjectDescription& object : world.description().objects)
        if (object.position)
            boxes.push_back(cornersOf(*object.position, object.orientation.toRotationMatrix(),
                                      object.halfSize));
    return boxes;
}

/// What of a box a composed picture shows: corners beyond its edge are moved to it, no further away
/// than what it is a picture of. Nothing where it does not show the box, or the box is around the
/// camera.
std::vector<Vec3> shownOf(const Corners& box, const OrbitCamera& camera) {
    std::vector<Vec3> shown;
    Vec3 low = Vec3::Constant(2), high = -low;
    for (const Vec3& corner : box) {
        const Vec3 seen = camera.project(corner, kComposedAspect);
        if (seen[2] <= 0) return {};
        low = low.cwiseMin(seen);
        high = high.cwiseMax(seen);
        const double x = std::clamp(seen[0], -1., 1.), y = std::clamp(seen[1], -1., 1.);
        const bool inside = x == seen[0] && y == seen[1];
        const double depth = inside ? seen[2] : std::min(seen[2], camera.distance());
        const Vec3 ray = camera.ray(x, y, kComposedAspect);
        shown.push_back(camera.description().position + depth / ray.dot(camera.forward()) * ray);
    }
    const bool beside = low[0] > 1 || low[1] > 1 || high[0] < -1 || high[1] < -1;
    return beside ? std::vector<Vec3>() : shown;
}

std::vector<Vec3> toBeSeen(const World& world, const OrbitCamera& camera, bool composed) {
    std::vector<Vec3> places;
    for (const Corners& box : boxesAtStart(world)) {
        if (!composed) {
            places.insert(places.end(), box.begin(), box.end());
            continue;
        }
        const std::vector<Vec3> shown = shownOf(box, camera);
        places.insert(places.end(), shown.begin(), shown.end());
    }
    return places;
}

/// m, by how much the camera is too near to see all places, with air around them.
double missing(const OrbitCamera& camera, const std::vector<Vec3>& places, double aspect) {
    const double tangent = std::tan(camera.description().fieldOfView * std::numbers::pi / 360);
    double most = 0;
    for (const Vec3& place : places) {
        const Vec3 seen = camera.inView(place);
        const double half = std::max(std::abs(seen[0]) / aspect, std::abs(seen[1]));
        most = std::max(most, half / (tangent * (1 - kMargin)) - seen[2]);
    }
    return most;
}

}  // namespace

std::optional<double> groundClearance(const World& world, const scene::CameraDescription& camera) {
    const render::SceneBounds bounds = render::sceneBounds(world);
    if (!bounds.ground) return std::nullopt;
    constexpr double kLeast = 0.05;
    const double halfView = camera.fieldOfView * std::numbers::pi / 360;
    return std::max(kLeast, 1.5 * nearestPlane(bounds) / std::cos(halfView));
}

scene::CameraDescription framed(const scene::CameraDescription& home, const World& world,
                                double aspect, bool composed) {
    OrbitCamera camera(home, groundClearance(world, home));
    if (composed && aspect >= kComposedAspect) return camera.description();
    const std::vector<Vec3> places = toBeSeen(world, camera, composed);
    // Once more where the ground has turned it on its way.
    for (int i = 0; i < 5; ++i) {
        const double back = missing(camera, places, aspect);
        if (back <= 0) break;
        camera.zoom(camera.distance() / (camera.distance() + back));
    }
    return camera.description();
}

}  // namespace sunder::view
