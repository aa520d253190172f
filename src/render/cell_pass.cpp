#include "render/cell_pass.hpp"

#include "render/cell_paint.hpp"
#include "render/uniforms.hpp"

namespace sunder {
namespace {

constexpr int kLawBinding = 0;

gl::ProgramDescription describe(CellPass::Output output) {
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
            break;
    }
    return description;
}

}  // namespace

CellPass::CellPass(Output output, const gpu::WorldBuffers& buffers,
                   const gl::VertexArray& noAttributes)
    : buffers_(buffers), noAttributes_(noAttributes), program_(describe(output)) {
    program_.bindSampler("cells", kCellUnit);
    program_.bindSampler("bodies", kBodyUnit);
    program_.bindSampler("damage", kBondUnit);
    program_.bindSampler("displacements", kNodeUnit);
    program_.bindSampler("rest", kRestUnit);
    if (output != Output::Depth) {
        program_.bindUniformBlock("ElementLaws", kLawBinding);
        CellPaint::bindSampler(program_);
    }
    if (output == Output::Shaded) program_.bindSampler("shadowMap", kShadowUnit);
}

const gl::Program& CellPass::begin() const {
    program_.use();
    return program_;
}

void CellPass::draw(const gpu::StateView& state, const glm::mat4& viewProjection) const {
    setUniform(program_, "viewProjection", viewProjection);
    gl::bindTexture(kCellUnit, GL_TEXTURE_BUFFER, buffers_.cells());
    gl::bindTexture(kBodyUnit, GL_TEXTURE_BUFFER, buffers_.bodies());
    gl::bindTexture(kBondUnit, GL_TEXTURE_BUFFER, *state.damage);
    glUniform1i(program_.uniform("damageStride"), state.damageStride);
    gl::bindTexture(kNodeUnit, GL_TEXTURE_BUFFER, *state.displacements);
    glUniform2i(program_.uniform("displacementStrides"), state.cellStride, state.cornerStride);
    gl::bindTexture(kRestUnit, GL_TEXTURE_BUFFER, buffers_.rest());
    glBindBufferBase(GL_UNIFORM_BUFFER, kLawBinding, buffers_.laws().id());
    glBindVertexArray(noAttributes_.id());
    glDrawArrays(GL_POINTS, 0, 6 * buffers_.cellCount());
}

}  // namespace sunder
