#include "render/cell_pass.hpp"

#include "render/shading.hpp"
#include "render/uniforms.hpp"

namespace sunder::render {
namespace {

gl::ProgramDescription describeCells(CellPass::Output output) {
    gl::ProgramDescription description{.vertex = "draw/cells.vert", .geometry = "draw/cells.geom"};
    switch (output) {
        case CellPass::Output::Depth:
            description.defines = {{"DEPTH_ONLY", "1"}};
            break;
        case CellPass::Output::Shaded:
            description.fragment = "draw/cells.frag";
            break;
        case CellPass::Output::Lines:
            description.fragment = "draw/wire.frag";
            description.defines = {{"LINES", "1"}};
            break;
        case CellPass::Output::Veil:
            description.fragment = "draw/veil.frag";
            description.defines = {{"DEPTH_ONLY", "1"}, {"TRANSPARENT", "1"}};
            break;
        case CellPass::Output::Transparent:
            description.fragment = "draw/cells.frag";
            description.defines = {{"TRANSPARENT", "1"}};
            break;
    }
    return description;
}

}  // namespace

CellPass::CellPass(Output output, const gpu::WorldBuffers& buffers,
                   const gl::VertexArray& noAttributes)
    : buffers_(buffers), noAttributes_(noAttributes), program_(describeCells(output)) {
    gpu::prepareWallState(program_, kWallUnit);
    Shading::prepare(program_);
}

const gl::Program& CellPass::begin() const {
    program_.use();
    return program_;
}

void CellPass::draw(const gpu::StateView& state, const glm::mat4& viewProjection) const {
    setUniform(program_, "viewProjection", viewProjection);
    gpu::bindWallState(program_, buffers_, state, kWallUnit);
    glBindVertexArray(noAttributes_.id());
    glDrawArrays(GL_POINTS, 0, 6 * buffers_.cellCount());
}

}  // namespace sunder::render
