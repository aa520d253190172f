#include "render/shading.hpp"

#include "render/uniforms.hpp"

namespace sunder::render {

using namespace core;

Shading::Shading(const World& world, const SceneBounds& bounds, const gl::VertexArray& noAttributes,
                 const Shading* like)
    : looks_(world),
      textures_(like && like->textures_->fits(world)
                    ? like->textures_
                    : std::make_shared<SurfaceTextures>(world, noAttributes)),
      shadows_(bounds, looks_.anyTransparent()),
      grounded_(bounds.ground) {}

void Shading::prepare(const gl::Program& program) {
    LookTable::prepare(program);
    SurfaceTextures::prepare(program);
    ShadowMap::prepare(program);
    CellPaint::bindSampler(program);
}

void Shading::bind(const gl::Program& program, const glm::vec3& eye) const {
    looks_.bind();
    textures_->bind(program);
    shadows_.bind(program);
    paint_.bind(program);
    setUniform(program, "grounded", grounded_);
    setUniform(program, "eye", eye);
}

}  // namespace sunder::render
