// Where the viewer's camera is at first: far enough back for the wall to be seen, above the ground.
#include "view/framing.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "catch.hpp"
#include "render/camera.hpp"
#include "view/orbit_camera.hpp"

using namespace sunder;
using namespace sunder::core;
using namespace sunder::view;

namespace {

/// How far out the corners of all bodies are in the picture: 1 is its edge.
double outermost(const World& world, const scene::CameraDescription& description, double aspect) {
    const OrbitCamera camera(description);
    double most = 0;
    for (const Body& body : world.bodies())
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 at(corner & 1, corner >> 1 & 1, corner >> 2);
            const Vec3 seen = camera.project(body.inWorld(at.cwiseProduct(body.size())), aspect);
            if (seen[2] <= 0) return 1e9;
            most = std::max({most, std::abs(seen[0]), std::abs(seen[1])});
        }
    return most;
}

bool same(const scene::CameraDescription& a, const scene::CameraDescription& b) {
    return (a.position - b.position).norm() + (a.target - b.target).norm() < 1e-9 &&
           a.fieldOfView == b.fieldOfView;
}

}  // namespace

TEST_CASE("Every preset's walls fit a view of any shape as they do a wide one", "[view]") {
    for (const scene::PresetInfo& preset : scene::scenePresets()) {
        CAPTURE(preset.name);
        const scene::Scene scene = scene::loadScene(preset.name);
        const World world(scene.world);
        const double composed = outermost(world, scene.camera, 16.0 / 9);
        for (const double aspect : {0.4, 560.0 / 600, 1.3, 1.7, 16.0 / 9, 2220.0 / 1080, 4.0}) {
            CAPTURE(aspect);
            const scene::CameraDescription camera = framed(scene.camera, world, aspect, true);
            if (aspect >= 16.0 / 9) CHECK(same(camera, scene.camera));
            // What a preset leaves out of its picture, it leaves out here.
            if (composed <= 1) CHECK(outermost(world, camera, aspect) <= 1);
            // Back, not aside: it looks the same way.
            const Vec3 before = (scene.camera.target - scene.camera.position).normalized();
            CHECK((camera.target - camera.position).normalized().dot(before) > 1 - 1e-9);
        }
    }
}

TEST_CASE("A wall nobody placed a camera for is seen whole", "[view]") {
    scene::Scene scene = scene::parseScene(
        "[[body]]\nname = \"long\"\nmaterial = \"brick\"\nsize = [40, 3, 0.2]\n"
        "cells = [80, 6, 1]\n",
        "long.toml", {});
    CHECK_FALSE(scene.ownCamera);
    const World world(scene.world);
    for (const double aspect : {0.5, 1.0, 2.0, 4.0}) {
        CAPTURE(aspect);
        const double out =
            outermost(world, framed(scene.camera, world, aspect, scene.ownCamera), aspect);
        CHECK(out <= 1);
        CHECK(out > 0.9);  // and no smaller than that asks for
    }
    // Turned, it is as long as it looks from there.
    scene.world.bodies[0].orientation = Eigen::AngleAxisd(1.2, Vec3::UnitY());
    const World turned(scene.world);
    const double out = outermost(turned, framed(scene.camera, turned, 2, scene.ownCamera), 2);
    CHECK(out <= 1);
    CHECK(out > 0.9);
    // One that fits is where it was.
    const World wood(scene::loadScene("wood").world);
    CHECK(same(framed(scene.camera, wood, 16.0 / 9, false), scene.camera));
}

TEST_CASE("A camera that somebody placed close to a wall stays close", "[view]") {
    const World world(scene::loadScene("brick").world);
    const scene::CameraDescription close{
        {1.2, 2.1, 0.6}, {1, 1.9, 0}, 45};  // both ends are out of sight
    CHECK(same(framed(close, world, 16.0 / 9, true), close));
    CHECK(same(framed(close, world, 3, true), close));
    // As wide a part of the wall as there: the picture is half as wide, so twice as far, and a
    // little more for the air around it.
    const scene::CameraDescription narrow = framed(close, world, 8.0 / 9, true);
    const double far = (close.position - close.target).norm();
    CHECK((narrow.position - narrow.target).norm() > 1.9 * far);
    CHECK((narrow.position - narrow.target).norm() < 2.2 * far);
}

TEST_CASE("Seen from the ground, a wall fits without the camera going into it", "[view]") {
    const World world(scene::loadScene("brick").world);
    const scene::CameraDescription low{{0, 0.1, 3}, {0, 1, 0}, 45};
    for (const double aspect : {0.4, 0.8}) {
        const scene::CameraDescription camera = framed(low, world, aspect, true);
        CHECK(camera.position[1] >= *groundClearance(world, low) - 1e-9);
        CHECK(outermost(world, camera, aspect) <= 1.0001);
    }
}

TEST_CASE("An eye at its lowest has its whole near plane above the ground", "[view]") {
    for (const char* name : {"brick", "stress", "cannon"})
        for (const double fieldOfView : {1.0, 45.0, 100.0, 170.0})
            for (const double pitch : {-1.5, -0.5, 0.0, 0.7, 1.5}) {
                CAPTURE(name, fieldOfView, pitch);
                const World world(scene::loadScene(name).world);
                scene::CameraDescription camera;
                camera.fieldOfView = fieldOfView;
                camera.position = {0, *groundClearance(world, camera), 4};
                camera.target = camera.position + Vec3(0, std::sin(pitch), -std::cos(pitch));
                for (const float aspect : {0.5f, 3.f}) {
                    const glm::mat4 back =
                        glm::inverse(render::makeCamera(camera, aspect, render::sceneBounds(world))
                                         .viewProjection());
                    for (const float x : {-1.f, 1.f}) {
                        const glm::vec4 corner = back * glm::vec4(x, -1, -1, 1);
                        CHECK(corner.y / corner.w > 0);
                    }
                }
            }
    scene::Scene scene = scene::loadScene("brick");
    scene.world.ground = false;
    CHECK_FALSE(groundClearance(World(scene.world), scene.camera));
}
