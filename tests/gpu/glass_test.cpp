// What is seen through glass.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "gpu/pictures.hpp"
#include "scene/scene.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

BodyDescription pane(double x, double z) {
    BodyDescription body;
    body.size = {1.2, 1, 0.02};
    body.cells = {12, 10, 1};
    body.position = {x, 0, z};
    return body;
}

/// Panes before a wall that is red on the left and green on the right.
WorldDescription panes(const std::vector<BodyDescription>& bodies) {
    WorldDescription description = wallDescription();
    description.materials[0].colour = {0.6, 0.05, 0.05};
    description.materials.push_back(description.materials[0]);
    description.materials[1].colour = {0.05, 0.5, 0.05};
    description.materials.push_back(scene::loadMaterial("glass"));
    description.bodies[0].regions = {{{4, 0, 0}, {7, 3, 0}, 1}};
    for (BodyDescription body : bodies) {
        body.material = 2;
        description.bodies.push_back(body);
    }
    return description;
}

image::Image still(const WorldDescription& description, render::DrawnMesh mesh) {
    const World world(description);
    return picture(world, world.initialState(), frontCamera(), render::DrawStyle::Solid, mesh);
}

}  // namespace

TEST_CASE("A wall is seen through a pane, a little changed", "[glass]") {
    for (const render::DrawnMesh mesh :
         {render::DrawnMesh::Simulation, render::DrawnMesh::Display}) {
        const image::Image bare = still(panes({}), mesh);
        const image::Image behind = still(panes({pane(0, 0.5)}), mesh);
        const image::Image behindTwo = still(panes({pane(0, 0.5), pane(0, 1)}), mesh);
        for (const int x : {120, 200}) {
            const std::size_t at = 3 * (std::size_t{100} * kWidth + x);
            const int colour = x == 120 ? 0 : 1, other = 1 - colour;
            CAPTURE(x);
            const auto contrast = [&](const image::Image& image) {
                return int{image.pixels[at + colour]} - int{image.pixels[at + other]};
            };
            CHECK(difference(bare, behind, x, 100) > 4);
            CHECK(contrast(behind) > 0.6 * contrast(bare));
            CHECK(contrast(behindTwo) < contrast(behind));
            CHECK(contrast(behindTwo) > 0.35 * contrast(bare));
        }
    }
}

TEST_CASE("Glass looks the same in whatever order it is drawn", "[glass]") {
    const BodyDescription front = pane(-0.2, 1), middle = pane(0.1, 0.7), back = pane(0.3, 0.4);
    for (const render::DrawnMesh mesh :
         {render::DrawnMesh::Simulation, render::DrawnMesh::Display}) {
        const image::Image one = still(panes({front, middle, back}), mesh);
        const image::Image two = still(panes({back, front, middle}), mesh);
        // Light is summed in half floats: in another order a sum of three may round by a level or
        // two (NVIDIA 580).
        CHECK(differing(one, two, 3) == 0);
        CHECK(differing(one, still(panes({front, middle}), mesh), 4) > 1000);
    }
}

TEST_CASE("A wall hides the glass behind it", "[glass]") {
    const image::Image bare = still(panes({}), render::DrawnMesh::Display);
    CHECK(differing(bare, still(panes({pane(0, -0.5)}), render::DrawnMesh::Display), 1) == 0);
}

TEST_CASE("Glass casts a lighter shadow than a wall", "[glass]") {
    WorldDescription description = wallDescription();
    description.ground = true;
    scene::CameraDescription above;
    above.position = {0, 8, 0};
    above.target = {0, 0, 0};
    const World opaque(description);
    description.materials = {scene::loadMaterial("glass")};
    const World clear(description);
    const image::Image empty = picture(opaque, nowhere(opaque), above);
    // Half a metre up the wall, thrown onto the ground by a sun at (-0.72, 0.85, 0.48).
    const glm::vec2 pixel = project(opaque, above, {0.4235f, 0, -0.2824f});
    const auto ratio = [&](const World& world) {
        const image::Image image = picture(world, world.initialState(), above);
        return static_cast<double>(
                   brightness(image, static_cast<int>(pixel.x), static_cast<int>(pixel.y))) /
               brightness(empty, static_cast<int>(pixel.x), static_cast<int>(pixel.y));
    };
    CHECK(ratio(clear) > 0.8);
    CHECK(ratio(clear) < 0.98);
    CHECK(ratio(opaque) < 0.75);
}
