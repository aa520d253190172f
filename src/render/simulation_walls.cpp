#include "render/simulation_walls.hpp"

#include "render/uniforms.hpp"

namespace sunder::render {
namespace {

void drawShaded(const CellPass& pass, const gpu::StateView& state, const Camera& camera,
                const Shading& shading, bool wire) {
    const gl::Program& program = pass.begin();
    shading.bind(program, camera.eye);
    setUniform(program, "wire", wire ? 1.f : 0.f);
    pass.draw(state, camera.viewProjection());
}

}  // namespace

SimulationWalls::SimulationWalls(const gpu::WorldBuffers& buffers,
                                 const gl::VertexArray& noAttributes, bool transparent)
    : depth_(CellPass::Output::Depth, buffers, noAttributes),
      shaded_(CellPass::Output::Shaded, buffers, noAttributes),
      lines_(CellPass::Output::Lines, buffers, noAttributes) {
    if (!transparent) return;
    veil_.emplace(CellPass::Output::Veil, buffers, noAttributes);
    transparent_.emplace(CellPass::Output::Transparent, buffers, noAttributes);
}

void SimulationWalls::drawDepth(const gpu::StateView& state, const glm::mat4& lightMatrix) const {
    depth_.begin();
    depth_.draw(state, lightMatrix);
}

void SimulationWalls::drawVeil(const gpu::StateView& state, const glm::mat4& lightMatrix) const {
    veil_->begin();
    veil_->draw(state, lightMatrix);
}

void SimulationWalls::drawOpaque(const gpu::StateView& state, const Camera& camera,
                                 const Shading& shading, bool wire) const {
    drawShaded(shaded_, state, camera, shading, wire);
}

void SimulationWalls::drawTransparent(const gpu::StateView& state, const Camera& camera,
                                      const Shading& shading, bool wire) const {
    drawShaded(*transparent_, state, camera, shading, wire);
}

void SimulationWalls::drawLines(const gpu::StateView& state, const Camera& camera,
                                const Shading& shading) const {
    shading.bind(lines_.begin(), camera.eye);
    lines_.draw(state, camera.viewProjection());
}

}  // namespace sunder::render
