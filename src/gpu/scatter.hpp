#pragma once
#include <array>

#include "gl/program.hpp"
#include "gpu/world_buffers.hpp"

namespace sunder::gpu {

/// The thesis's GPU method, figure by figure: points scatter nodal forces and stresses into float
/// textures by additive blending (6.4, 7.2), a connectivity pass adds up joined nodes (7.4), node
/// (6.5) and fracture (7.3) updates feed back through transform feedback with ping-pong buffers.
/// Nothing is read back while it advances.
///
/// Needs a current GL context for as long as it lives.
class ScatterSolver : public GpuSolver {
  public:
    /// Throws InputError when the world is too large for the device. `world` and `buffers` must
    /// outlive it.
    ScatterSolver(const World& world, const WorldBuffers& buffers);

    std::string_view name() const override { return "scatter"; }
    void advance(int steps) override;
    void finish() override;
    State state() const override;
    void setState(const State& state) override;
    StateView view() const override;

  private:
    /// Reading order of vertex attributes and the buffers behind a state: [current] is read, [1 −
    /// current] written.
    struct NodeSide {
        NodeBuffer nodes;
        gl::VertexArray attributes;
    };
    struct BondSide {
        BondBuffer bonds;
        gl::VertexArray attributes;
    };

    void makeElementBuffers();
    void makeTargets();
    void makePrograms();
    void writeEvents();
    void updateElements(bool fracture);
    void updateConnectivity();
    void updateNodes(int stepInFrame);
    void updateFracture();
    void updateLinks();
    /// Runs `program` over `count` vertices with its outputs captured in `target`.
    void feedback(const gl::Program& program, const gl::VertexArray& attributes,
                  const gl::Buffer& target, int count);

    const World& world_;
    const WorldBuffers& buffers_;
    std::int64_t step_ = 0;
    int height_;  ///< rows of the float textures

    gl::Buffer elementBuffer_, strengthBuffer_, linkBuffer_, eventBuffer_;
    gl::Texture linkTexture_, eventTexture_;
    gl::VertexArray elementAttributes_, noAttributes_;
    std::array<NodeSide, 2> nodes_;
    std::array<BondSide, 2> bonds_;
    int currentNodes_ = 0, currentBonds_ = 0;

    gl::Texture forceTexture_, stressTexture_, cumulativeTexture_, discardTexture_;
    gl::Framebuffer elementTarget_, cumulativeTarget_, discardTarget_;
    /// elementPrograms_[1] also computes stresses.
    std::array<gl::Program, 2> elementPrograms_;
    gl::Program connectivityProgram_, nodeProgram_, fractureProgram_, linkProgram_;
    GLint stepInFrameUniform_ = -1;
};

}  // namespace sunder::gpu
