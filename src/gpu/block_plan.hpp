#pragma once
#include <limits>
#include <vector>

#include "core/world.hpp"
#include "gpu/layout.hpp"

namespace sunder::gpu {

/// How bodies are divided into blocks of cells for a pass that does several substeps at once
/// (glsl/compute/block.comp). A small body is one block. A larger one is many, each with a rim of
/// cells that others own: what happens in a substep is known one cell farther, so as many substeps
/// may go by as the rim is wide until blocks have to hear of each other.
class BlockPlan {
  public:
    /// Cells: a fracture look takes two, for what it breaks shows in the joints of a cell one
    /// farther. With three, blocks of a wall were so many that it took longer.
    static constexpr int kRim = 2;

    /// mostCells: that a block may have, from 64.
    BlockPlan(const core::World& world, int mostCells);

    /// The blocks of a body.
    std::vector<BlockRecord> blocksOf(int body) const;
    /// Whether a body is one block.
    bool whole(int body) const;
    /// Of the largest block.
    int cells() const { return cells_; }
    /// What a substep of all bodies takes, in the time that one takes a cell of a block: a block is
    /// as slow as its cells are many, and so many blocks go at a time.
    /// kNoRoom where even one cell with its rim would be too large a block.
    int work() const { return cells_ > mostCells_ ? kNoRoom : cells_ * wavesOf(blocks_); }
    static constexpr int kNoRoom = std::numeric_limits<int>::max();

  private:
    static int wavesOf(int blocks);
    /// Cells along each axis that a block of a body owns, at most; `bodies` like it have to be
    /// divided.
    core::IVec3 divided(const core::Body& body, int bodies) const;

    const core::World& world_;
    int mostCells_;
    std::vector<core::IVec3> owned_;  ///< of each body, cells along each axis that a block owns
    int cells_ = 0, blocks_ = 0;
};

}  // namespace sunder::gpu
