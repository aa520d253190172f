#include "gpu/pictures.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "catch.hpp"
#include "gpu/test_context.hpp"

using namespace sunder;
using namespace sunder::core;

WorldDescription wallDescription() {
    WorldDescription description;
    Material material;
    material.colour = {0.4, 0.2, 0.1};
    description.materials = {material};
    BodyDescription wall;
    wall.name = "wall";
    wall.size = {2, 1, 0.1};
    wall.cells = {8, 4, 1};
    description.bodies = {wall};
    description.ground = false;
    return description;
}

scene::CameraDescription frontCamera() {
    scene::CameraDescription camera;
    camera.position = {0, 0.5, 3};
    camera.target = {0, 0.5, 0};
    return camera;
}

State shifted(const World& world, const Vec3& by) {
    State state = world.initialState();
    std::fill(state.displacement.begin(), state.displacement.end(), by);
    return state;
}

State nowhere(const World& world) {
    return shifted(world, {0, -500, 0});
}

Painter::Painter(const World& world)
    : buffers_((testContext(), world)), upload_(world), renderer_(world, buffers_) {}

image::Image Painter::picture(const State& state, const scene::CameraDescription& camera,
                              render::RenderSettings settings) {
    settings.width = kWidth;
    settings.height = kHeight;
    image::Image image = renderer_.draw(upload_.upload(state), camera, settings);
    const std::vector<std::string> errors = testContext().takeErrors();
    CAPTURE(errors);
    CHECK(errors.empty());
    REQUIRE(image.width == kWidth);
    REQUIRE(image.height == kHeight);
    return image;
}

image::Image picture(const World& world, const State& state, const scene::CameraDescription& camera,
                     render::RenderSettings settings) {
    return Painter(world).picture(state, camera, settings);
}

image::Image picture(const World& world, const State& state, const scene::CameraDescription& camera,
                     render::DrawStyle style, render::DrawnMesh mesh) {
    render::RenderSettings settings;
    settings.mesh = mesh;
    settings.style = style;
    return picture(world, state, camera, settings);
}

glm::vec2 project(const World& world, const scene::CameraDescription& description,
                  const glm::vec3& p) {
    const render::Camera camera = render::makeCamera(
        description, static_cast<float>(kWidth) / kHeight, render::sceneBounds(world));
    const glm::vec4 clip = camera.viewProjection() * glm::vec4(p, 1);
    return {(0.5f + 0.5f * clip.x / clip.w) * kWidth, (0.5f - 0.5f * clip.y / clip.w) * kHeight};
}

int brightness(const image::Image& image, int x, int y) {
    const std::uint8_t* p = &image.pixels[3 * (std::size_t{static_cast<unsigned>(y)} * kWidth + x)];
    return p[0] + p[1] + p[2];
}

int difference(const image::Image& a, const image::Image& b, int x, int y) {
    int most = 0;
    for (int channel = 0; channel < 3; ++channel) {
        const std::size_t i = 3 * (std::size_t{static_cast<unsigned>(y)} * kWidth + x) + channel;
        most = std::max(most, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
    }
    return most;
}

int differing(const image::Image& a, const image::Image& b, int threshold,
              const std::function<bool(float x, float y)>& counts) {
    int number = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            number += difference(a, b, x, y) > threshold &&
                      counts(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    return number;
}
