#include "render/display_walls.hpp"

#include "render/uniforms.hpp"

namespace sunder::render {

using namespace core;

namespace {

using Output = DisplayPass::Output;
using Part = DisplayBuffers::Part;

}  // namespace

DisplayWalls::DisplayWalls(const World& world, const gpu::WorldBuffers& buffers)
    : mesh_(world),
      buffers_(mesh_),
      depth_(Output::Depth, buffers, buffers_),
      shaded_(Output::Shaded, buffers, buffers_),
      lines_(Output::Lines, buffers, buffers_) {
    if (buffers_.empty(Part::Transparent)) return;
    veil_.emplace(Output::Veil, buffers, buffers_);
    transparent_.emplace(Output::Transparent, buffers, buffers_);
}

void DisplayWalls::drawDepth(const gpu::StateView& state, const glm::mat4& lightMatrix) const {
    depth_.begin();
    depth_.draw(state, lightMatrix, Part::Opaque);
}

void DisplayWalls::drawVeil(const gpu::StateView& state, const glm::mat4& lightMatrix) const {
    veil_->begin();
    veil_->draw(state, lightMatrix, Part::Transparent);
}

void DisplayWalls::drawOpaque(const gpu::StateView& state, const Camera& camera,
                              const Shading& shading, bool wire) const {
    shading.bind(shaded_.begin(), camera.eye);
    // Room for the lines in front of the surface that they are on.
    if (wire) glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 2);
    shaded_.draw(state, camera.viewProjection(), Part::Opaque);
    glDisable(GL_POLYGON_OFFSET_FILL);
    if (!wire) return;
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    drawLines(state, camera, shading);
    glDisable(GL_BLEND);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void DisplayWalls::drawTransparent(const gpu::StateView& state, const Camera& camera,
                                   const Shading& shading, bool) const {
    shading.bind(transparent_->begin(), camera.eye);
    transparent_->draw(state, camera.viewProjection(), Part::Transparent);
}

void DisplayWalls::drawLines(const gpu::StateView& state, const Camera& camera,
                             const Shading& shading) const {
    shading.bind(lines_.begin(), camera.eye);
    for (const Part part : {Part::Opaque, Part::Transparent})
        lines_.draw(state, camera.viewProjection(), part);
}

}  // namespace sunder::render
