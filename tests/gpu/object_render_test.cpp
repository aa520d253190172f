// Pictures of objects: balls, boxes, capsules and chains whose pixels can be foretold.
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "../../glsl/draw/sun.h"
#include "catch.hpp"
#include "core/types.hpp"
#include "gpu/pictures.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// The wall's world and objects that touch nothing of it: drawn with the wall out of sight.
WorldDescription objectWorld(const std::vector<ObjectDescription>& objects) {
    WorldDescription description = wallDescription();
    description.contact = true;
    description.objects = objects;
    return description;
}

ObjectDescription object(ObjectShape shape, const Vec3& halfSize) {
    ObjectDescription description;
    description.shape = shape;
    description.halfSize = halfSize;
    description.position = Vec3(0, 0.5, 0);
    description.mayOverlap = true;  // with the wall, which is moved away
    description.orientation = Eigen::AngleAxisd(0.9, Vec3(0.5, -0.3, 0.8).normalized());
    description.colour = {0.8, 0.1, 0.1};  // unlike the sky wherever it is lit or not
    return description;
}

/// m: from an object's surface to the ray through a pixel; negative where the ray hits it.
double gapBesideRay(const Object& object, const ObjectState& state,
                    const scene::CameraDescription& camera, float x, float y) {
    const double tangent = std::tan(camera.fieldOfView * 3.141592653589793 / 360);
    // The camera looks along -z.
    const Vec3 direction =
        Vec3((2 * x / kWidth - 1) * tangent * kWidth / kHeight, (1 - 2 * y / kHeight) * tangent, -1)
            .normalized();
    const auto gapAt = [&](double way) {
        const Vec3 p =
            state.orientation.conjugate() * (camera.position + way * direction - state.position);
        return (p - p.cwiseMax(-object.core).cwiseMin(object.core)).norm() - object.radius;
    };
    // Distance to a convex core has one minimum along a line.
    double low = 0, high = 10;
    for (int i = 0; i < 60; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (gapAt(a) < gapAt(b) ? high : low) = gapAt(a) < gapAt(b) ? b : a;
    }
    return gapAt(low);
}

}  // namespace

TEST_CASE("Objects cover the pixels whose rays meet them", "[long][render]") {
    const World bare(wallDescription());
    const image::Image background = picture(bare, nowhere(bare), frontCamera());
    for (const ObjectDescription& description :
         {object(ObjectShape::Sphere, {0.4, 0.4, 0.4}), object(ObjectShape::Box, {0.6, 0.3, 0.25}),
          object(ObjectShape::Capsule, {0.2, 0.6, 0.2})}) {
        CAPTURE(static_cast<int>(description.shape));
        const World world(objectWorld({description}));
        State state = nowhere(world);
        for (const Vec3& at : {Vec3(0, 0.5, 1), Vec3(0.3, 0.4, 0.8)}) {
            CAPTURE(at);
            state.objects[0].position = at;
            const image::Image image = picture(world, state, frontCamera());
            State walled = state;
            walled.displacement = world.initialState().displacement;
            const image::Image beforeWall = picture(world, walled, frontCamera());
            // A pixel has samples up to 0.71 pixels from its centre, and the mesh is a third of a
            // pixel inside the true surface at most.
            const double pixel = (3 - at[2]) * 2 * std::tan(0.3926990817) / kHeight;
            const double margin = 1.1 * pixel;
            int covered = 0, holes = 0, cracks = 0, strays = 0;
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    const double gap =
                        gapBesideRay(world.objects()[0], state.objects[0], frontCamera(),
                                     static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                    const int change = difference(image, background, x, y);
                    covered += gap < -margin;
                    holes += gap < -margin && change <= 8;
                    cracks += gap < -margin && difference(image, beforeWall, x, y) > 1;
                    strays += gap > margin && change > 2;
                }
            CHECK(covered * pixel * pixel > 0.25);
            CHECK(holes == 0);
            CHECK(cracks == 0);  // even a thin one lets the wall's colour through
            CHECK(strays == 0);
        }
    }
}

TEST_CASE("An object is lit from the sun's side, and shows its spin", "[render]") {
    const World world(objectWorld({object(ObjectShape::Sphere, {0.4, 0.4, 0.4})}));
    State state = nowhere(world);
    state.objects[0].orientation = Eigen::AngleAxisd(0.7, Vec3::UnitY());  // bands aside
    const image::Image image = picture(world, state, frontCamera());
    // The sun comes from the camera's side, from the upper left.
    const auto at = [&](float x, float y) {
        const glm::vec2 p = project(world, frontCamera(), {x, 0.5f + y, 0.3f});
        return brightness(image, static_cast<int>(p.x), static_cast<int>(p.y));
    };
    CHECK(at(0, 0) > 1.3 * at(0.2f, -0.22f));
    CHECK(at(-0.15f, 0.15f) > at(0, 0));

    state.objects[0].orientation = Eigen::AngleAxisd(0.9, Vec3::UnitY());
    const int moved = differing(image, picture(world, state, frontCamera()), 8);
    CHECK(moved > 100);
}

TEST_CASE("Nothing inside an object is seen", "[render]") {
    ObjectDescription inside = object(ObjectShape::Box, {0.1, 0.1, 0.1});
    inside.colour = {0, 1, 0};
    const World world(objectWorld({object(ObjectShape::Sphere, {0.4, 0.4, 0.4}), inside}));
    State hollow = nowhere(world);
    hollow.objects[1].present = false;
    CHECK(differing(picture(world, nowhere(world), frontCamera()),
                    picture(world, hollow, frontCamera()), 0) == 0);
}

TEST_CASE("An object that is not there is not drawn", "[render]") {
    const World bare(wallDescription());
    ObjectDescription ball = object(ObjectShape::Sphere, {0.3, 0.3, 0.3});
    ball.position.reset();
    const World world(objectWorld({ball, object(ObjectShape::Box, {0.1, 0.1, 0.1})}));
    State state = world.initialState();
    CHECK_FALSE(state.objects[0].present);
    state.objects[1].present = false;
    state.objects[1].position = Vec3(0, 0.5, 1);
    for (const render::DrawStyle style : {render::DrawStyle::Solid, render::DrawStyle::Wireframe})
        CHECK(differing(picture(world, state, frontCamera(), style),
                        picture(bare, bare.initialState(), frontCamera(), style), 2) == 0);
}

TEST_CASE("A hanging object has a chain", "[render]") {
    ObjectDescription ball = object(ObjectShape::Sphere, {0.2, 0.2, 0.2});
    ball.hungFrom = Vec3(0.4, 1.4, 0);
    const World world(objectWorld({ball}));
    const World bare(wallDescription());
    const image::Image background = picture(bare, nowhere(bare), frontCamera());
    const image::Image image = picture(world, nowhere(world), frontCamera());
    for (float along = 0.01f; along < 1; along += 0.01f) {
        const glm::vec3 p = glm::mix(glm::vec3(0.4f, 1.4f, 0), glm::vec3(0, 0.5f, 0), along);
        const glm::vec2 pixel = project(world, frontCamera(), p);
        CHECK(difference(image, background, static_cast<int>(pixel.x), static_cast<int>(pixel.y)) >
              8);
    }
}

TEST_CASE("Objects have lines in a wireframe", "[render]") {
    const World world(objectWorld({object(ObjectShape::Sphere, {0.4, 0.4, 0.4})}));
    State absent = nowhere(world);
    absent.objects[0].present = false;
    const image::Image background = picture(world, absent, frontCamera());
    const int solid = differing(picture(world, nowhere(world), frontCamera()), background, 8);
    const int lines = differing(
        picture(world, nowhere(world), frontCamera(), render::DrawStyle::Wireframe), background, 8);
    CHECK(lines > solid / 10);
    CHECK(lines < solid * 9 / 10);
}

TEST_CASE("An object throws its shadow on the ground and on walls", "[render]") {
    using glm::vec3;
    WorldDescription description = objectWorld({object(ObjectShape::Sphere, {0.2, 0.2, 0.2})});
    description.ground = true;
    description.objects[0].position = Vec3(-0.6, 1.4, 0.6);
    const World world(description);
    State absent = world.initialState();
    absent.objects[0].present = false;
    scene::CameraDescription camera;
    camera.position = {1, 1.5, 4};
    camera.target = {0, 0.5, 0};
    const auto ratio = [&](const State& with, const State& without, const vec3& p) {
        const glm::vec2 pixel = project(world, camera, p);
        const int x = static_cast<int>(pixel.x), y = static_cast<int>(pixel.y);
        return static_cast<double>(brightness(picture(world, with, camera), x, y)) /
               brightness(picture(world, without, camera), x, y);
    };
    const vec3 centre(-0.6f, 1.4f, 0.6f);
    const vec3 sun = glm::normalize(SUNDER_SUN_DIRECTION);
    const vec3 onWall = centre - sun * ((centre.z - 0.05f) / sun.z);
    CHECK(ratio(world.initialState(), absent, onWall) < 0.75);
    CHECK(ratio(world.initialState(), absent, onWall + vec3(0.45f, 0, 0)) ==
          Approx(1).margin(0.02));

    State open = world.initialState(), empty = absent;
    for (State* state : {&open, &empty}) state->displacement = nowhere(world).displacement;
    const vec3 onGround = centre - sun * (centre.y / sun.y);
    CHECK(ratio(open, empty, onGround) < 0.75);
}

TEST_CASE("A scene's bounds hold its objects and where they come from", "[render]") {
    WorldDescription description = objectWorld({object(ObjectShape::Box, {0.1, 0.1, 0.1})});
    description.objects[0].position = Vec3(0, 0.5, 4);
    ObjectDescription hanging = object(ObjectShape::Sphere, {0.1, 0.1, 0.1});
    hanging.hungFrom = Vec3(0, 5, 0);
    ObjectDescription thrown = object(ObjectShape::Sphere, {0.1, 0.1, 0.1});
    thrown.position.reset();
    description.objects.insert(description.objects.end(), {hanging, thrown});
    description.throws = {{.object = 2, .from = {-4, 0.5, 0}},
                          {.time = 1, .object = 2, .from = {0, -1000, 0}}};
    const render::SceneBounds bounds = render::sceneBounds(World(description));
    CHECK(bounds.high.z >= 4.1f);
    CHECK(bounds.high.y == 5);
    CHECK(bounds.low.x == Approx(-4.1f));
    CHECK(bounds.low.y > -10);  // thrown from too far away
}
