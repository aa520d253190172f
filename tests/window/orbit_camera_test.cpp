#include "view/orbit_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"

using sunder::core::Vec3;
using sunder::scene::CameraDescription;
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
    camera.orbit(0, 0);
    camera.move(0, 0, 0);
    CHECK_FALSE(camera.moved());
    camera.orbit(1, 0.3);
    camera.pan(0.2, -0.1);
    camera.zoom(3);
    camera.move(1, 2, 3);
    CHECK(apart(camera.description().position, kHome.position) > 1);
    CHECK(camera.moved());
    camera.setHome(kHome);
    CHECK_FALSE(camera.moved());
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

TEST_CASE("Above ground, whatever is done to it, the eye stays above", "[view]") {
    constexpr double kClearance = 0.05;
    std::mt19937 random(7);
    const auto number = [&](double most) {
        return std::uniform_real_distribution(-most, most)(random);
    };
    OrbitCamera camera(kHome, kClearance);
    CHECK(apart(camera.description().position, kHome.position) < 1e-12);
    double least = 1;
    for (int i = 0; i < 20000; ++i) {
        switch (i % 4) {
            case 0:
                camera.orbit(number(2), number(2));
                break;
            case 1:
                camera.pan(number(1), number(1));
                break;
            case 2:
                camera.zoom(std::exp(number(1.5)));
                break;
            default:
                camera.move(number(1), number(1), number(1));
        }
        const CameraDescription now = camera.description();
        REQUIRE(now.position.allFinite());
        least = std::min(least, now.position[1]);
        // Rounding of a distance of up to 1000 m.
        REQUIRE(now.position[1] >= kClearance - 1e-9);
        REQUIRE(now.target[1] >= -1e-9);
        REQUIRE(apart(now.position, now.target) > 0.04);
    }
    CHECK(least < kClearance + 1e-6);  // it was there
}

TEST_CASE("Along the ground it turns, rises and stops, and does not look elsewhere", "[view]") {
    constexpr double kClearance = 0.05;
    OrbitCamera camera(kHome, kClearance);
    camera.orbit(0.4, -10);
    CHECK(camera.description().position[1] == Approx(kClearance));
    CHECK(apart(camera.description().target, kHome.target) < 1e-12);
    // Further away, still up at its target.
    camera.zoom(0.1);
    CHECK(camera.description().position[1] == Approx(kClearance));
    CHECK(apart(camera.description().target, kHome.target) < 1e-12);

    camera.setHome(kHome, kClearance);
    const Vec3 ahead = camera.forward();
    camera.move(0, 0, -100);
    CHECK(camera.description().position[1] == Approx(kClearance));
    CHECK(apart(camera.forward(), ahead) < 1e-9);
    CHECK(camera.description().target[1] == Approx(0).margin(1e-9));
    camera.zoom(1e6);
    CHECK(camera.description().position[1] == Approx(kClearance));
    CHECK(apart(camera.forward(), ahead) < 1e-9);

    // Without ground there is no such thing.
    camera.setHome(kHome);
    camera.orbit(0, -10);
    CHECK(camera.description().position[1] < -2);
}

TEST_CASE("A scene that has its camera in the ground is looked at from above it", "[view]") {
    const OrbitCamera camera({{2, -1, 3}, {0, 0.9, 0}, 45}, 0.05);
    CHECK(camera.description().position[1] == Approx(0.05));
    CHECK(apart(camera.description().target, {0, 0.9, 0}) < 1e-12);
    // One that looks at what is below the ground keeps its view.
    const CameraDescription down{{2, 1, 3}, {0, -1, 0}, 45};
    const OrbitCamera low(down, 0.05);
    CHECK(apart(low.description().position, down.position) < 1e-12);
    CHECK(apart(low.forward(), (down.target - down.position).normalized()) < 1e-12);
    CHECK(apart(low.description().target, {1, 0, 1.5}) < 1e-12);
}
