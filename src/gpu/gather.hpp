#pragma once
#include <array>

#include "gpu/bond_pass.hpp"
#include "gpu/event_buffer.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {

/// The fast GPU method: one vertex per cell computes its five tetrahedra and writes the forces on
/// its eight nodes by transform feedback; a second pass, again one vertex per cell, gathers for
/// each node the forces of the joined copies and writes eight new states. No geometry shader, no
/// blending, the same result on every run of one driver. Fracture and links run only on the steps
/// that need them; nothing is read back while it advances.
///
/// Needs a current GL context for as long as it lives.
class GatherSolver : public GpuSolver {
  public:
    /// Throws InputError when the world is too large for the device. `world` and `buffers` must
    /// outlive it.
    GatherSolver(const World& world, const WorldBuffers& buffers);

    std::string_view name() const override { return "gather"; }
    void advance(int steps) override;
    void finish() override;
    State state() const override;
    void setState(const State& state) override;
    StateView view() const override;

  private:
    void updateElements(bool fracture);
    void updateNodes(bool events, int stepInFrame);

    const World& world_;
    const WorldBuffers& buffers_;
    std::int64_t step_ = 0;
    Feedback feedback_;
    BondPass bonds_;
    EventBuffer events_;
    std::array<NodeBuffer, 2> nodes_;  ///< [current_] is read, the other written
    int current_ = 0;
    gl::Buffer forceBuffer_, stressBuffer_;
    gl::Texture forceTexture_, stressTexture_;
    std::array<gl::Program, 2> elementPrograms_;  ///< [1] also computes stresses
    std::array<gl::Program, 2> nodePrograms_;     ///< [1] also applies events
    GLint stepInFrameUniform_ = -1;
};

}  // namespace sunder::gpu
