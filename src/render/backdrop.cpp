#include "render/backdrop.hpp"

#include <algorithm>
#include <cmath>

#include "render/uniforms.hpp"

namespace sunder::render {
namespace {

/// Half a metre for a wall; doubled for wider scenes, so that a picture never holds thousands of
/// tiles. m
float tileSize(const SceneBounds& bounds) {
    return 0.5f * std::exp2(std::max(0.f, std::floor(std::log2(bounds.radius() / 5))));
}

}  // namespace

Backdrop::Backdrop(const SceneBounds& bounds, const gl::VertexArray& noAttributes)
    : bounds_(bounds),
      noAttributes_(noAttributes),
      sky_({.vertex = "draw/sky.vert", .fragment = "draw/sky.frag"}),
      ground_({.vertex = "draw/ground.vert", .fragment = "draw/ground.frag"}) {
    Shading::prepare(sky_);
    Shading::prepare(ground_);
}

void Backdrop::draw(const Camera& camera, const Shading& shading, bool shadowed) const {
    glBindVertexArray(noAttributes_.id());
    glDisable(GL_CULL_FACE);
    if (bounds_.ground) drawGround(camera, shading, shadowed);
    sky_.use();
    shading.bind(sky_, camera.eye);
    // Without the view's translation: a direction far from the origin would lose its digits.
    setUniform(sky_, "inverseViewProjection",
               glm::inverse(camera.projection * glm::mat4(glm::mat3(camera.view))));
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Backdrop::drawGround(const Camera& camera, const Shading& shading, bool shadowed) const {
    const float extent = groundExtent(bounds_, camera.eye);
    ground_.use();
    shading.bind(ground_, camera.eye);
    setUniform(ground_, "viewProjection", camera.viewProjection());
    setUniform(ground_, "extent", extent);
    setUniform(ground_, "tile", tileSize(bounds_));
    setUniform(ground_, "hazeLength", 0.24f * extent);
    setUniform(ground_, "room", bounds_.room);
    setUniform(ground_, "shadowed", shadowed);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace sunder::render
