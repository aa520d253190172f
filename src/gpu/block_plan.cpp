#include "gpu/block_plan.hpp"

#include <algorithm>

namespace sunder::gpu {

using namespace core;

namespace {

/// Blocks that go at a time: as many as fit NVIDIA's H200, by how times grow with their number. A
/// GPU with room for more or fewer loses time by the wrong choice, nothing else.
constexpr int kBlocksAtOnce = 40;
/// Along an axis; with more there would be more blocks than are worth while.
constexpr int kMostParts = 40;

/// Stretches of an axis that blocks own; the last one is as long as the others or shorter.
int partsOf(int cells, int owned) {
    return (cells + owned - 1) / owned;
}

/// Cells of a block along an axis of a body, rim and all, at most.
int extentOf(int cells, int owned) {
    const int rims = std::min(2, partsOf(cells, owned) - 1);
    return std::min(cells, owned + rims * BlockPlan::kRim);
}

ivec4 toIvec4(const IVec3& v, int w) {
    return {v[0], v[1], v[2], w};
}

}  // namespace

BlockPlan::BlockPlan(const World& world, int mostCells) : world_(world), mostCells_(mostCells) {
    const auto count = static_cast<int>(world.bodies().size());
    int large = 0;
    for (int body = 0; body < count; ++body) large += !whole(body);
    for (int body = 0; body < count; ++body) {
        const Body& of = world.bodies()[body];
        // Copies stand beside each other.
        const bool again = body > 0 && of.cells == world.bodies()[body - 1].cells;
        owned_.push_back(again ? owned_.back() : whole(body) ? of.cells : divided(of, large));
        int blocks = 1, cells = 1;
        for (int axis = 0; axis < 3; ++axis) {
            blocks *= partsOf(of.cells[axis], owned_.back()[axis]);
            cells *= extentOf(of.cells[axis], owned_.back()[axis]);
        }
        blocks_ += blocks;
        cells_ = std::max(cells_, cells);
    }
}

bool BlockPlan::whole(int body) const {
    return world_.bodies()[body].cellCount() <= mostCells_;
}

int BlockPlan::wavesOf(int blocks) {
    return (blocks + kBlocksAtOnce - 1) / kBlocksAtOnce;
}

IVec3 BlockPlan::divided(const Body& body, int bodies) const {
    IVec3 best{1, 1, 1}, parts;
    int least = kNoRoom;
    const IVec3 most = body.cells.cwiseMin(kMostParts);
    for (parts[2] = 1; parts[2] <= most[2]; ++parts[2])
        for (parts[1] = 1; parts[1] <= most[1]; ++parts[1])
            for (parts[0] = 1; parts[0] <= most[0]; ++parts[0]) {
                IVec3 owned, extent;
                for (int axis = 0; axis < 3; ++axis) {
                    owned[axis] = partsOf(body.cells[axis], parts[axis]);
                    extent[axis] = extentOf(body.cells[axis], owned[axis]);
                }
                if (extent.prod() > mostCells_) continue;
                const int work = extent.prod() * wavesOf(bodies * parts.prod());
                if (work >= least) continue;
                least = work;
                best = owned;
            }
    return best;
}

std::vector<BlockRecord> BlockPlan::blocksOf(int index) const {
    const Body& body = world_.bodies()[index];
    const IVec3& owned = owned_[index];
    std::vector<BlockRecord> blocks;
    for (int z = 0; z < body.cells[2]; z += owned[2])
        for (int y = 0; y < body.cells[1]; y += owned[1])
            for (int x = 0; x < body.cells[0]; x += owned[0]) {
                const IVec3 first{x, y, z}, end = (first + owned).cwiseMin(body.cells);
                const IVec3 low = (first.array() - kRim).cwiseMax(0),
                            high = (end.array() + kRim).min(body.cells.array());
                blocks.push_back({toIvec4(low, index), toIvec4(high - low, 0),
                                  toIvec4(first - low, 0), toIvec4(end - low, 0)});
            }
    return blocks;
}

}  // namespace sunder::gpu
