#pragma once
#include <optional>

#include "render/cell_pass.hpp"
#include "render/walls.hpp"

namespace sunder::render {

/// The hull of the tetrahedra (thesis, figure 6.6). Cracks (broken bonds between faces that still
/// touch) show as dark lines.
class SimulationWalls : public Walls {
  public:
    /// `transparent`: whether a material is.
    SimulationWalls(const gpu::WorldBuffers&, const gl::VertexArray& noAttributes,
                    bool transparent);
    void drawDepth(const gpu::StateView&, const glm::mat4& lightMatrix) const override;
    void drawVeil(const gpu::StateView&, const glm::mat4& lightMatrix) const override;
    void drawOpaque(const gpu::StateView&, const Camera&, const Shading&, bool wire) const override;
    void drawTransparent(const gpu::StateView&, const Camera&, const Shading&,
                         bool wire) const override;
    void drawLines(const gpu::StateView&, const Camera&, const Shading&) const override;

  private:
    CellPass depth_, shaded_, lines_;
    std::optional<CellPass> veil_, transparent_;
};

}  // namespace sunder::render
