#include "gpu/wall_state.hpp"

namespace sunder::gpu {

void prepareWallState(const gl::Program& program, int firstUnit) {
    for (const char* sampler : {"cells", "bodies", "damage", "displacements", "rest"})
        program.bindSampler(sampler, firstUnit++);
}

void bindWallState(const gl::Program& program, const WorldBuffers& buffers, const StateView& state,
                   int firstUnit) {
    for (const gl::Texture* texture :
         {&buffers.cells(), &buffers.bodies(), state.damage, state.displacements, &buffers.rest()})
        gl::bindTexture(firstUnit++, GL_TEXTURE_BUFFER, *texture);
    glUniform1i(program.uniform("damageStride"), state.damageStride);
    glUniform2i(program.uniform("displacementStrides"), state.cellStride, state.cornerStride);
}

}  // namespace sunder::gpu
