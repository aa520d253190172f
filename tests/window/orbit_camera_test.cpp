#include "view/orbit_camera.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"

using sunder::CameraDescription;
using sunder::Vec3;
using sunder::view::OrbitCamera;

namespace {

const CameraDescription kHome{{1.5, 1.4, 3.7}, {0, 0.95, 0}, 45};

double apart(const Vec3& a, const Vec3& b) {
    return (a - b).norm();
}

}  // namespace

TEST_CASE("A camera starts where the scene has it, and comes back", "[view]") {
    OrbitCamera camera(kHome);
    CHECK(apart(camera.description().position, kHome.position) < 1e-12);
    CHECK(apart(camera.description().target, kHome.target) < 1e-12);
    camera.orbit(1, 0.3);
    camera.pan(0.2, -0.1);
    camera.zoom(3);
    camera.move(1, 2, 3);
    CHECK(apart(camera.description().position, kHome.position) > 1);
    camera.reset();
    CHECK(apart(camera.description().position, kHome.position) < 1e-12);
}

TEST_CASE("Orbiting keeps the target and the distance, and never turns over", "[view]") {
    OrbitCamera camera(kHome);
    const double distance = camera.distance();
    camera.orbit(0.7, 0.2);
    CHECK(apart(camera.description().target, kHome.target) < 1e-12);
    CHECK(apart(camera.description().position, camera.description().target) == Approx(distance));
    // A whole turn leads back.
    const Vec3 before = camera.description().position;
    camera.orbit(2 * std::numbers::pi, 0);
    CHECK(apart(camera.description().position, before) < 1e-9);
    camera.orbit(0, 100);
    CHECK(camera.forward()[1] > -1);
    CHECK(camera.forward()[1] < -0.99);
    camera.orbit(0, -100);
    CHECK(camera.forward()[1] > 0.99);
}

TEST_CASE("Zooming in by 2 halves the distance, and it stays in front of the target", "[view]") {
    OrbitCamera camera(kHome);
    const double distance = camera.distance();
    camera.zoom(2);
    CHECK(camera.distance() == Approx(distance / 2));
    camera.zoom(1e9);
    CHECK(camera.distance() > 0.01);
    camera.zoom(1e-12);
    CHECK(camera.distance() < 1e4);
}

TEST_CASE("Panning by a share of the picture moves the target by that share", "[view]") {
    OrbitCamera camera(kHome);
    const double aspect = 16.0 / 9;
    camera.pan(0.25, 0.1);  // of the height
    const Vec3 seen = camera.project(kHome.target, aspect);
    CHECK(seen[0] == Approx(2 * 0.25 / aspect));
    CHECK(seen[1] == Approx(2 * 0.1));
}

TEST_CASE("Keys move ahead on the level, however it looks down", "[view]") {
    OrbitCamera camera(kHome);
    const Vec3 before = camera.description().position;
    camera.move(2, 0, 0);
    const Vec3 moved = camera.description().position - before;
    CHECK(moved.norm() == Approx(2));
    CHECK(moved[1] == Approx(0).margin(1e-12));
    CHECK(moved.dot(camera.forward()) > 1.9);
}

TEST_CASE("What a ray through the picture meets is seen where the ray went", "[view]") {
    OrbitCamera camera(kHome);
    camera.orbit(2, -0.5);
    for (const double aspect : {0.5, 1.0, 1.9})
        for (const double x : {-1.0, 0.0, 0.6})
            for (const double y : {-0.7, 0.0, 1.0}) {
                const Vec3 ray = camera.ray(x, y, aspect);
                CHECK(ray.norm() == Approx(1));
                const Vec3 seen = camera.project(camera.description().position + 3.3 * ray, aspect);
                CHECK(seen[0] == Approx(x).margin(1e-12));
                CHECK(seen[1] == Approx(y).margin(1e-12));
                CHECK(seen[2] > 0);
            }
    CHECK(camera.project(camera.description().position - camera.forward(), 1)[2] < 0);
}
