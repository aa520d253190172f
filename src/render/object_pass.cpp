#include "render/object_pass.hpp"

#include <algorithm>
#include <cmath>

#include "render/shading.hpp"
#include "render/uniforms.hpp"

namespace sunder::render {

using namespace core;

namespace {

// Quads along an octant's edge. 7.5 degrees each: the outline of a ball of 100 pixels is exact to
// a quarter of one.
constexpr int kSegments = 6;
constexpr int kLineSegments = 2;  // fewer: lines would hide one another
constexpr int kLinkSegments = 2;
constexpr double kMostLinks = 400;

gl::ProgramDescription describeObjects(CellPass::Output output) {
    gl::ProgramDescription description{.vertex = "draw/objects.vert"};
    if (output == CellPass::Output::Shaded) description.fragment = "draw/objects.frag";
    if (output == CellPass::Output::Lines) {
        description.fragment = "draw/wire.frag";
        description.defines = {{"FLAT", "1"}};
    }
    return description;
}

/// As long as a link of that thickness (draw/objects.vert) looks well.
int linkCount(const Object& object) {
    const double size = object.core.minCoeff() + object.radius;
    return static_cast<int>(std::clamp(std::ceil(object.chain / (0.4 * size)), 1.0, kMostLinks));
}

}  // namespace

ObjectPass::ObjectPass(CellPass::Output output, const World& world,
                       const gpu::WorldBuffers& buffers, const gl::VertexArray& noAttributes)
    : buffers_(buffers),
      noAttributes_(noAttributes),
      program_(describeObjects(output)),
      segments_(output == CellPass::Output::Lines ? kLineSegments : kSegments) {
    program_.bindSampler("objects", kObjectUnit);
    program_.bindSampler("places", kPlaceUnit);
    Shading::prepare(program_);
    for (std::size_t i = 0; i < world.objects().size(); ++i)
        if (world.objects()[i].chain > 0)
            chains_.push_back({static_cast<int>(i), linkCount(world.objects()[i])});
}

const gl::Program& ObjectPass::begin() const {
    program_.use();
    return program_;
}

void ObjectPass::draw(const gpu::StateView& state, const glm::mat4& viewProjection) const {
    setUniform(program_, "viewProjection", viewProjection);
    glUniform1i(program_.uniform("objectCount"), buffers_.objectCount());
    gl::bindTexture(kObjectUnit, GL_TEXTURE_BUFFER, buffers_.objects());
    gl::bindTexture(kPlaceUnit, GL_TEXTURE_BUFFER, *state.objects);
    glBindVertexArray(noAttributes_.id());
    drawBoxes(-1, buffers_.objectCount(), segments_);
    for (const Chain& chain : chains_) {
        glUniform1i(program_.uniform("links"), chain.links);
        drawBoxes(chain.object, chain.links, kLinkSegments);
    }
}

void ObjectPass::drawBoxes(int chained, int count, int segments) const {
    glUniform1i(program_.uniform("chained"), chained);
    glUniform1i(program_.uniform("segments"), segments);
    const int row = 2 * segments + 1;
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * 6 * row * row, count);
}

}  // namespace sunder::render
