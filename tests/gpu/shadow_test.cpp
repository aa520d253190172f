// Edges of shadows.
#include <algorithm>
#include <vector>

#include "../../glsl/draw/sun.h"
#include "catch.hpp"
#include "gpu/pictures.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// m: how wide the edge of the shadow is that the right side of a narrow wall throws on the ground
/// from `height`.
double edgeWidth(const World& world, float height) {
    using glm::vec3;
    const vec3 sun = SUNDER_SUN_DIRECTION;
    const glm::vec3 edge = glm::vec3(0.3f, height, 0) - sun * (height / sun.y);  // on the ground
    scene::CameraDescription above;
    above.position = {edge.x, 2.5, edge.z};
    above.target = {edge.x, 0, edge.z};
    const image::Image empty = picture(world, nowhere(world), above);
    const image::Image image = picture(world, world.initialState(), above);
    // Along x through the middle of the picture, averaged over rows that follow the edge: it runs
    // away from the sun, by 0.72 in x for -0.48 in z.
    std::vector<double> light;
    for (int x = 130; x < 230; ++x) {
        double sum = 0;
        for (const int down : {-2, 0, 2}) {
            const int column = x - down * 3 / 2, row = kHeight / 2 + down;
            sum += static_cast<double>(brightness(image, column, row)) /
                   brightness(empty, column, row) / 3;
        }
        light.push_back(sum);
    }
    const auto ends = std::minmax_element(light.begin(), light.end());
    const double dark = *ends.first, bright = *ends.second;
    CHECK(bright == Approx(1).margin(0.02));
    CHECK(dark < 0.75);
    const auto between = std::count_if(light.begin(), light.end(), [&](double l) {
        const double t = (l - dark) / (bright - dark);
        return t > 0.15 && t < 0.85;
    });
    const double pixel = 2.5 * 2 * 0.4142135624 / kHeight;
    return static_cast<double>(between) * pixel;
}

}  // namespace

TEST_CASE("A shadow is sharp at its caster and soft far from it", "[shadow]") {
    WorldDescription description = wallDescription();
    description.ground = true;
    description.bodies[0].size = {0.6, 2, 0.1};
    description.bodies[0].cells = {3, 10, 1};
    const World world(description);
    const double near = edgeWidth(world, 0.2f), far = edgeWidth(world, 1.7f);
    CAPTURE(near, far);
    CHECK(near < 0.045);
    CHECK(far > 2 * near);
    CHECK(far < 0.15);
}

TEST_CASE("No light leaks under a wall, and no wall shades itself", "[shadow]") {
    WorldDescription description = wallDescription();
    description.ground = true;
    const World world(description);
    // Behind the foot of the wall, a centimetre from it.
    scene::CameraDescription behind;
    behind.position = {0.3, 0.9, -1.6};
    behind.target = {0.3, 0, -0.1};
    const image::Image empty = picture(world, nowhere(world), behind);
    const image::Image image = picture(world, world.initialState(), behind);
    for (float x = -0.5f; x < 0.9f; x += 0.05f) {
        const glm::vec2 p = project(world, behind, {x, 0, -0.06f});
        const int column = static_cast<int>(p.x), row = static_cast<int>(p.y) + 1;
        if (column < 0 || column >= kWidth) continue;
        CAPTURE(x);
        CHECK(brightness(image, column, row) < 0.75 * brightness(empty, column, row));
    }
    // The sunlit front is of one colour but for its highlight and the floor's shade: no acne.
    description.ground = false;
    const World floating(description);
    for (const Vec3& eye : {Vec3(0, 0.5, 3), Vec3(-2, 1.5, 2), Vec3(2, 0.2, 2)}) {
        scene::CameraDescription camera;
        camera.position = eye;
        camera.target = {0, 0.5, 0};
        const image::Image front = picture(floating, floating.initialState(), camera);
        int least = 1000, most = 0;
        for (float x = -0.95f; x < 0.95f; x += 0.013f)
            for (float y = 0.05f; y < 0.95f; y += 0.013f) {
                const glm::vec2 p = project(floating, camera, {x, y, 0.05f});
                const int sum = brightness(front, static_cast<int>(p.x), static_cast<int>(p.y));
                least = std::min(least, sum);
                most = std::max(most, sum);
            }
        CHECK(most - least < 0.12 * most);
    }
}
