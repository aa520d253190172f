#pragma once
#include <optional>

#include "render/display_pass.hpp"
#include "render/walls.hpp"

namespace sunder::render {

/// What a player sees: sections with torn edges (thesis, figure 8.1; surface/display_mesh.hpp).
class DisplayWalls : public Walls {
  public:
    DisplayWalls(const core::World&, const gpu::WorldBuffers&);
    const surface::DisplayMesh& mesh() const { return mesh_; }

    void drawDepth(const gpu::StateView&, const glm::mat4& lightMatrix) const override;
    void drawVeil(const gpu::StateView&, const glm::mat4& lightMatrix) const override;
    void drawOpaque(const gpu::StateView&, const Camera&, const Shading&, bool wire) const override;
    void drawTransparent(const gpu::StateView&, const Camera&, const Shading&,
                         bool wire) const override;
    void drawLines(const gpu::StateView&, const Camera&, const Shading&) const override;

  private:
    surface::DisplayMesh mesh_;
    DisplayBuffers buffers_;
    DisplayPass depth_, shaded_, lines_;
    std::optional<DisplayPass> veil_, transparent_;
};

}  // namespace sunder::render
