#pragma once
#include <memory>

#include "render/cell_paint.hpp"
#include "render/look_table.hpp"
#include "render/shadow_map.hpp"
#include "render/surface_textures.hpp"

namespace sunder::render {

/// Everything that glsl/draw/surface.glsl reads: looks, textures, sun and shadow; and what it may
/// be painted with instead. One for a world.
class Shading {
  public:
    /// Shares the textures of `like`, if there is one and they are what this world needs.
    Shading(const core::World&, const SceneBounds&, const gl::VertexArray& noAttributes,
            const Shading* like);

    /// Once for a program that includes draw/surface.glsl, or a part of it.
    static void prepare(const gl::Program&);
    /// For the program in use, before it draws.
    void bind(const gl::Program&, const glm::vec3& eye) const;

    const LookTable& looks() const { return looks_; }
    const ShadowMap& shadows() const { return shadows_; }
    CellPaint& paint() { return paint_; }

  private:
    LookTable looks_;
    std::shared_ptr<const SurfaceTextures> textures_;
    ShadowMap shadows_;
    CellPaint paint_;
    bool grounded_;
};

}  // namespace sunder::render
