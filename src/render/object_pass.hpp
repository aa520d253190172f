#pragma once
#include <vector>

#include "render/cell_pass.hpp"

namespace sunder::render {

/// Draws a world's objects, and the chains that they hang from.
class ObjectPass {
  public:
    ObjectPass(CellPass::Output, const core::World&, const gpu::WorldBuffers&,
               const gl::VertexArray& noAttributes);

    /// In use after this; set further uniforms of it before draw().
    const gl::Program& begin() const;
    void draw(const gpu::StateView&, const glm::mat4& viewProjection) const;

  private:
    struct Chain {
        int object, links;
    };
    void drawBoxes(int chained, int count, int segments) const;

    const gpu::WorldBuffers& buffers_;
    const gl::VertexArray& noAttributes_;
    std::vector<Chain> chains_;
    gl::Program program_;
    int segments_;
};

}  // namespace sunder::render
