#pragma once
#include <array>

#include "core/body_host.hpp"
#include "gpu/event_buffer.hpp"
#include "gpu/feedback.hpp"
#include "gpu/rest_monitor.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// The fast GPU method: every pass fills float textures, ping-pong. One fragment per cell computes
/// its five tetrahedra and writes the forces on its eight nodes; one fragment per node gathers the
/// forces of the joined copies and writes the new state. No geometry shader, no blending, the same
/// result on every run of one driver. Stresses, bonds and links run only on the steps that need
/// them; nothing is read back while it advances. Bodies at rest sleep (core/sleep.hpp): the passes
/// leave their texels out.
///
/// Fragments rather than vertices with transform feedback: on an NVIDIA H200 feedback writes some
/// four thousand million floats a second and no more, which is what a step then takes.
///
/// Needs a current GL context for as long as it lives.
class GatherSolver : public GpuSolver, public BodyHost {
  public:
    /// Throws InputError when the world is too large for the device. `world` and `buffers` must
    /// outlive it.
    GatherSolver(const World& world, const WorldBuffers& buffers);

    std::string_view name() const override { return "gather"; }
    void advance(int steps) override;
    void finish() override;
    State state() const override;
    void setState(const State& state) override;
    bool asleep(int body) const override { return bodies_[body] == BodyState::Asleep; }
    StateView view() override;

    void adopt(int body, const State& state) override;
    void release(int body, State& state) override;
    bool holds(int body) const override { return bodies_[body] != BodyState::Elsewhere; }
    /// Where a body that another solver holds is to be drawn.
    void show(int body, const State& state);

  private:
    enum class BodyState { Awake, Asleep, Elsewhere };
    /// Texels that a set of bodies has in textures of cells and of nodes.
    struct BodyRanges {
        TexelRanges cells, nodes;
        explicit BodyRanges(std::size_t bodies)
            : cells(bodies, "ranges of cells"), nodes(bodies, "ranges of nodes") {}
        void set(const World& world, const std::vector<int>& bodies, int columns);
    };
    /// A texture buffer that a layer is copied to for drawing.
    struct Copy {
        gl::Buffer buffer;
        gl::Texture texture;
        void update(const TexelTarget& from, int layer, const char* what);
    };

    gl::Program texelProgram(const char* fragment, const TexelTarget& target,
                             gl::Defines defines = {}) const;
    void bindInputs() const;
    void write(TexelRange cells, const State& state);
    void read(TexelRange cells, State& state) const;
    void watch();
    void fallAsleep(const std::vector<int>& bodies);
    void wakePushed();
    void bodiesChanged();
    void updateBonds();
    void updateLinks();
    void updateNodes(bool events, int stepInFrame);

    const World& world_;
    const WorldBuffers& buffers_;
    std::int64_t step_ = 0;
    bool breakable_;
    int columns_;  ///< of all textures
    EventBuffer events_;
    std::array<TexelTarget, 2> nodes_;  ///< per node: displacement (w: rest height); velocity (w:
                                        ///< largest squared speed since the last look)
    std::array<TexelTarget, 2> bonds_;  ///< per cell: BondRecord
    TexelTarget forces_;                ///< per cell: force on each corner
    TexelTarget stresses_;              ///< per cell: glsl/gather/stress.glsl
    TexelTarget links_;                 ///< per cell: LinkRecord
    int currentNodes_ = 0, currentBonds_ = 0;  ///< read; the other is written
    Copy drawnNodes_, drawnDamage_;
    gl::Program forceProgram_, stressProgram_, bondProgram_, linkProgram_;
    std::array<gl::Program, 2> nodePrograms_;  ///< [1] also applies events
    gl::Program stillNodeProgram_, stillBondProgram_;
    GLint stepInFrameUniform_ = -1, bondWatchUniform_ = -1;
    std::array<GLint, 2> nodeWatchUniforms_{};

    std::vector<BodyState> bodies_;
    BodyRanges awake_;
    RestMonitor monitor_;
    bool newNodeWatch_ = true, newBondWatch_ = true;  ///< no step, no update since the last look
    std::int64_t nextWake_ = 0;  ///< no event acts on a sleeping body before this step
};

}  // namespace sunder::gpu
