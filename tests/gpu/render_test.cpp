// Pictures of worlds whose pixels can be foretold.
#include <algorithm>
#include <cmath>
#include <vector>

#include "../../glsl/draw/sun.h"
#include "catch.hpp"
#include "core/types.hpp"
#include "gpu/pictures.hpp"
#include "gpu/test_context.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("A wall covers the pixels that its corners project to", "[render]") {
    const World world(wallDescription());
    const image::Image background = picture(world, nowhere(world), frontCamera());
    for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.3, -0.2, 0), Vec3(-0.15, 0.1, 0.7)}) {
        CAPTURE(shift);
        const image::Image image = picture(world, shifted(world, shift), frontCamera());
        const glm::vec3 by(shift[0], shift[1], shift[2]);
        const glm::vec2 low = project(world, frontCamera(), by + glm::vec3(-1, 1, 0.05f));
        const glm::vec2 high = project(world, frontCamera(), by + glm::vec3(1, 0, 0.05f));
        // The rectangle, smaller or larger by `margin` pixels; side faces point away from the
        // camera or are hidden only when the wall is in the middle, so outside some room is left
        // for them.
        const auto inside = [&](float margin) {
            return [=](float x, float y) {
                return x > low.x - margin && x < high.x + margin && y > low.y - margin &&
                       y < high.y + margin;
            };
        };
        const int expected = static_cast<int>((high.x - low.x - 2) * (high.y - low.y - 2));
        CHECK(differing(image, background, 8, inside(-1)) >= expected - 2 * (kWidth + kHeight));
        const auto outside = inside(8);
        CHECK(differing(image, background, 2, [&](float x, float y) { return !outside(x, y); }) ==
              0);
        // Not one pixel well inside shows the background.
        int holes = 0;
        for (int y = static_cast<int>(low.y) + 3; y < static_cast<int>(high.y) - 3; ++y)
            for (int x = static_cast<int>(low.x) + 3; x < static_cast<int>(high.x) - 3; ++x)
                holes += difference(image, background, x, y) <= 8;
        CHECK(holes == 0);
    }
}

TEST_CASE("The background shows through a removed cell", "[render]") {
    WorldDescription description = wallDescription();
    const World whole(description);
    description.bodies[0].regions = {{{4, 2, 0}, {4, 2, 0}, -1}};
    const World holed(description);
    const image::Image background = picture(whole, nowhere(whole), frontCamera());
    const image::Image image = picture(holed, holed.initialState(), frontCamera());

    const auto colourAt = [&](float x, float y) {
        const glm::vec2 p = project(holed, frontCamera(), {x, y, 0});
        return difference(image, background, static_cast<int>(p.x), static_cast<int>(p.y));
    };
    CHECK(colourAt(0.125f, 0.625f) <= 2);  // middle of the removed cell
    for (const auto& [x, y] :
         {std::pair{-0.125f, 0.625f}, {0.375f, 0.625f}, {0.125f, 0.375f}, {0.125f, 0.875f}}) {
        CAPTURE(x, y);
        CHECK(colourAt(x, y) > 8);
    }
}

TEST_CASE("A body that is not there is in no picture and casts no shadow", "[render]") {
    WorldDescription description = wallDescription();
    const World alone(description);
    BodyDescription visitor = description.bodies[0];
    visitor.name = "visitor";
    visitor.position += Vec3(0.5, 0, 0.6);  // before the wall, on the way of the light
    description.bodies.push_back(visitor);
    const World both(description);
    description.bodies[1].present = false;
    const World absent(description);
    for (const render::DrawnMesh mesh :
         {render::DrawnMesh::Display, render::DrawnMesh::Simulation}) {
        CAPTURE(mesh);
        const auto drawn = [&](const World& world) {
            return picture(world, world.initialState(), frontCamera(), render::DrawStyle::Solid,
                           mesh);
        };
        const image::Image wall = drawn(alone);
        CHECK(differing(wall, drawn(both), 8) > 1000);
        // By one of 255 levels at most: sky and shadow map leave room for it, and so round
        // otherwise.
        CHECK(differing(wall, drawn(absent), 1) == 0);
    }
}

TEST_CASE("A broken bond that has not opened is a dark line, and nothing else", "[render]") {
    const World world(wallDescription());
    const Body& wall = world.bodies()[0];
    for (int axis = 0; axis < 2; ++axis) {
        CAPTURE(axis);
        State state = world.initialState();
        state.damage[kBondsPerCell * wall.cellAt({3, 2, 0}) + axis] = 1;
        const image::Image intact = picture(world, world.initialState(), frontCamera());
        const image::Image cracked = picture(world, state, frontCamera());

        // The bond's face meets the wall's front in the edge from `from` to `to`.
        const glm::vec3 to(0, 0.75f, 0.05f);
        const glm::vec3 from =
            axis == 0 ? glm::vec3(0, 0.5f, 0.05f) : glm::vec3(-0.25f, 0.75f, 0.05f);
        const glm::vec2 a = project(world, frontCamera(), from),
                        b = project(world, frontCamera(), to);
        const glm::vec2 middle = 0.5f * (a + b);
        int darkest = 1000;
        for (int dy = -2; dy <= 1; ++dy)
            for (int dx = -2; dx <= 1; ++dx)
                darkest = std::min(darkest, brightness(cracked, static_cast<int>(middle.x) + dx,
                                                       static_cast<int>(middle.y) + dy));
        const int before =
            brightness(intact, static_cast<int>(middle.x), static_cast<int>(middle.y));
        CHECK(darkest < 2 * before / 3);

        const glm::vec2 low = glm::min(a, b) - 2.5f, high = glm::max(a, b) + 2.5f;
        const auto near = [&](float x, float y) {
            return x > low.x && x < high.x && y > low.y && y < high.y;
        };
        CHECK(differing(intact, cracked, 8, near) >= static_cast<int>(0.8f * glm::length(b - a)));
        CHECK(differing(intact, cracked, 8, [&](float x, float y) { return !near(x, y); }) == 0);
    }
}

TEST_CASE("The three styles show what they say", "[render]") {
    const World world(wallDescription());
    const image::Image background = picture(world, nowhere(world), frontCamera());
    const State rest = world.initialState();
    const image::Image solid = picture(world, rest, frontCamera());
    const image::Image wire = picture(world, rest, frontCamera(), render::DrawStyle::Wireframe);
    const image::Image overlay = picture(world, rest, frontCamera(), render::DrawStyle::Overlay);

    const int wall = differing(solid, background, 8);
    const int lines = differing(wire, background, 8);
    const int drawnOver = differing(overlay, solid, 8);
    CHECK(lines > wall / 20);
    CHECK(lines < wall / 2);
    CHECK(drawnOver > wall / 20);
    CHECK(drawnOver < wall / 2);
    CHECK(differing(overlay, background, 8) >= wall * 99 / 100);

    // The diagonals are those of the tetrahedra: in the front of cell (4, 2), where i + j + k is
    // even, the central tetrahedron has the corners 5 and 6, so the line falls from the top left to
    // the bottom right. In (5, 2) it rises.
    const auto lineAt = [&](float x, float y) {
        const glm::vec2 p = project(world, frontCamera(), {x, y, 0.05f});
        int most = 0;
        for (int d = -1; d <= 0; ++d)
            most = std::max(
                most, difference(overlay, solid, static_cast<int>(p.x) + d, static_cast<int>(p.y)));
        return most;
    };
    CHECK(lineAt(0.0625f, 0.6875f) > 8);
    CHECK(lineAt(0.0625f, 0.5625f) <= 8);
    CHECK(lineAt(0.3125f, 0.5625f) > 8);
    CHECK(lineAt(0.3125f, 0.6875f) <= 8);
}

TEST_CASE("A wall throws its shadow on the ground, away from the sun", "[render]") {
    WorldDescription description = wallDescription();
    description.ground = true;
    const World world(description);
    scene::CameraDescription above;  // straight down: where "up" in the picture has to be chosen
    above.position = {0, 8, 0};
    above.target = {0, 0, 0};
    const image::Image empty = picture(world, nowhere(world), above);
    const image::Image image = picture(world, world.initialState(), above);

    using glm::vec3;
    const vec3 sun = glm::normalize(SUNDER_SUN_DIRECTION);
    const vec3 halfWay(0, 0.5f, 0);
    const vec3 offset = sun * (halfWay.y / sun.y) - halfWay;
    const auto ratio = [&](const vec3& p) {
        const glm::vec2 pixel = project(world, above, p);
        const int x = static_cast<int>(pixel.x), y = static_cast<int>(pixel.y);
        return static_cast<double>(brightness(image, x, y)) / brightness(empty, x, y);
    };
    CHECK(ratio(-offset) < 0.75);
    CHECK(ratio(offset) == Approx(1).margin(0.02));
}

TEST_CASE("Drawing leaves GL ready for the simulation", "[render]") {
    const World world(wallDescription());
    picture(world, world.initialState(), frontCamera(), render::DrawStyle::Wireframe);
    for (const GLenum state : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND, GL_FRAMEBUFFER_SRGB,
                               GL_DEPTH_CLAMP, GL_RASTERIZER_DISCARD, GL_SCISSOR_TEST}) {
        CAPTURE(state);
        CHECK(glIsEnabled(state) == GL_FALSE);
    }
    GLint mode[2] = {};  // compatible drivers report front and back
    glGetIntegerv(GL_POLYGON_MODE, mode);
    CHECK(mode[0] == GL_FILL);

    const gpu::WorldBuffers buffers(world);
    gpu::StateUpload upload(world);
    render::Renderer renderer(world, buffers);
    renderer.draw(upload.upload(world.initialState()), frontCamera(), render::RenderSettings{});
    CHECK(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    CHECK(testContext().takeErrors().empty());
}

TEST_CASE("A renderer outlives a picture that is too large", "[render]") {
    testContext();
    const World world(wallDescription());
    const gpu::WorldBuffers buffers(world);
    gpu::StateUpload upload(world);
    render::Renderer renderer(world, buffers);
    const gpu::StateView view = upload.upload(world.initialState());
    for (const auto& [width, height] :
         {std::pair{0, 100}, {100, -1}, {1 << 20, 10}, {16000, 16000}}) {
        CAPTURE(width, height);
        render::RenderSettings settings;
        settings.width = width;
        settings.height = height;
        CHECK_THROWS_AS(renderer.draw(view, frontCamera(), settings), InputError);
    }
    render::RenderSettings settings;
    settings.width = 33;
    settings.height = 17;
    settings.samples = 1000;  // clamped
    CHECK(renderer.draw(view, frontCamera(), settings).pixels.size() == std::size_t{3} * 33 * 17);
    CHECK(testContext().takeErrors().empty());
}
