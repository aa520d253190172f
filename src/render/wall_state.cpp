#include "render/wall_state.hpp"

#include "render/uniforms.hpp"

namespace sunder::render {

void prepareWallState(const gl::Program& program) {
    program.bindSampler("cells", kCellUnit);
    program.bindSampler("bodies", kBodyUnit);
    program.bindSampler("damage", kBondUnit);
    program.bindSampler("displacements", kNodeUnit);
    program.bindSampler("rest", kRestUnit);
}

void bindWallState(const gl::Program& program, const gpu::WorldBuffers& buffers,
                   const gpu::StateView& state) {
    gl::bindTexture(kCellUnit, GL_TEXTURE_BUFFER, buffers.cells());
    gl::bindTexture(kBodyUnit, GL_TEXTURE_BUFFER, buffers.bodies());
    gl::bindTexture(kBondUnit, GL_TEXTURE_BUFFER, *state.damage);
    glUniform1i(program.uniform("damageStride"), state.damageStride);
    gl::bindTexture(kNodeUnit, GL_TEXTURE_BUFFER, *state.displacements);
    glUniform2i(program.uniform("displacementStrides"), state.cellStride, state.cornerStride);
    gl::bindTexture(kRestUnit, GL_TEXTURE_BUFFER, buffers.rest());
}

}  // namespace sunder::render
