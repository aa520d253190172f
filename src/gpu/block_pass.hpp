#pragma once
#include <optional>

#include "gpu/block_plan.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// Several substeps of bodies that touch nothing in one compute dispatch (glsl/compute/block.comp):
/// what a pass costs beside its arithmetic is paid once, and nodes stay in registers. Whatever
/// happens to a cell by itself and its neighbours: elements, both kinds of fracture, joints,
/// events, ground and room; neither contact nor objects.
class BlockPass {
  public:
    /// None where a pass after the other is faster: with contact, or where too many cells would be
    /// worked out more than once.
    static std::optional<BlockPlan> planFor(const core::World& world);

    /// plan: as planFor() says; columns: of the solver's textures.
    BlockPass(const core::World& world, BlockPlan plan, int columns);

    /// Those that are awake.
    void setBodies(const std::vector<int>& bodies);

    /// Substeps that may follow each other from `step` on, at most `most`.
    int substepsFrom(std::int64_t step, int most) const;

    struct Span {
        std::int64_t step;
        int substeps;     ///< as substepsFrom() says
        bool pushed;      ///< an event may act
        int stepInFrame;  ///< of the first substep: what events' times count from
        bool newNodeWatch, newBondWatch;
    };
    /// Whether bonds are tested in these substeps.
    bool looks(const Span& span) const;
    /// Nodes, bonds and links are read from the textures that are bound; it writes nodes, and where
    /// it looks bonds and links, of the bodies' cells.
    void run(const Span& span, const TexelTarget& nodes, const TexelTarget& bonds,
             const TexelTarget& links) const;

  private:
    /// Substeps from `step` to the next look.
    int untilLook(std::int64_t step) const;

    const core::World& world_;
    BlockPlan plan_;
    bool allWhole_ = true;  ///< of the bodies that are awake
    int blockCount_ = 0;
    gl::Buffer blockBuffer_;
    gl::Texture blockTexture_;
    gl::Program program_;
    struct {
        GLint substeps, pushed, stepInFrame, newNodeWatch, newBondWatch, firstLook;
    } uniforms_;
};

}  // namespace sunder::gpu
