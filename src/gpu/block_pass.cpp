#include "gpu/block_pass.hpp"

#include <algorithm>
#include <utility>

#include "gpu/cell_pass.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

/// Image units that glsl/compute/block.comp writes.
enum Image { kNewNodes, kNewBonds, kNewLinks };

/// What glsl/compute/block.comp shares: for a cell, and beside all cells.
constexpr int kBytesPerCell = (48 + 24 + 45 + 9 + 1) * 4, kBytes = 4;
constexpr int kInvocationsPerCell = 8;
/// Invocations of a group come in some thirty-two that go in step.
constexpr int kUnit = 32 / kInvocationsPerCell;

/// That the device has room for.
int mostCells() {
    const int memory = (gl::limit(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE) - kBytes) / kBytesPerCell;
    const int most =
        std::min(memory, gl::limit(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS) / kInvocationsPerCell);
    return most / kUnit * kUnit;
}

int roundedUp(int cells) {
    return (cells + kUnit - 1) / kUnit * kUnit;
}

/// More work than this takes as long as a pass after the other, each of which takes some time
/// whatever it does: that of 330 cells of a block (NVIDIA's H200).
constexpr int kMostWork = 300;

}  // namespace

std::optional<BlockPlan> BlockPass::planFor(const World& world) {
    if (world.description().contact) return std::nullopt;
    BlockPlan plan(world, mostCells());
    if (plan.work() > kMostWork) return std::nullopt;
    return plan;
}

BlockPass::BlockPass(const World& world, BlockPlan plan, int columns)
    : world_(world),
      plan_(std::move(plan)),
      program_(
          {.compute = "compute/block.comp",
           .defines = withTurned({{"BONDS_BREAK", world.bondsBreak() ? "1" : "0"},
                                  {"CELLS_BREAK", world.cellsBreak() ? "1" : "0"},
                                  {"ROOM", world.description().room ? "1" : "0"},
                                  {"BLOCK_CELLS", std::to_string(roundedUp(plan_.cells()))},
                                  {"BLOCK_INVOCATIONS",
                                   std::to_string(kInvocationsPerCell * roundedUp(plan_.cells()))}},
                                 world.anyTurned())}) {
    setConstants(program_, world, columns);
    program_.bindSampler("blocks", kCellGroups);
    glUniform1i(program_.uniform("newNodes"), kNewNodes);
    glUniform1i(program_.uniform("newBonds"), kNewBonds);
    glUniform1i(program_.uniform("newLinks"), kNewLinks);
    glUniform1i(program_.uniform("lookInterval"), world.fractureInterval());
    uniforms_ = {program_.uniform("substeps"),     program_.uniform("pushed"),
                 program_.uniform("stepInFrame"),  program_.uniform("newNodeWatch"),
                 program_.uniform("newBondWatch"), program_.uniform("firstLook")};
}

void BlockPass::setBodies(const std::vector<int>& bodies) {
    std::vector<BlockRecord> blocks;
    allWhole_ = true;
    for (const int body : bodies) {
        allWhole_ &= plan_.whole(body);
        const std::vector<BlockRecord> own = plan_.blocksOf(body);
        blocks.insert(blocks.end(), own.begin(), own.end());
    }
    blockCount_ = static_cast<int>(blocks.size());
    const std::size_t bytes = blocks.size() * sizeof(BlockRecord);
    if (blockBuffer_.size() < bytes) {
        blockBuffer_ = gl::Buffer(bytes, nullptr, GL_DYNAMIC_DRAW, "blocks");
        blockTexture_ = gl::makeBufferTexture(blockBuffer_, GL_RGBA32I, "blocks");
    }
    if (bytes > 0) blockBuffer_.write(0, bytes, blocks.data());
}

int BlockPass::untilLook(std::int64_t step) const {
    const int interval = world_.fractureInterval();
    return static_cast<int>((interval - step % interval) % interval);
}

int BlockPass::substepsFrom(std::int64_t step, int most) const {
    if (allWhole_) return most;
    // A look comes first, or not at all.
    if (world_.breakable()) {
        const int look = untilLook(step);
        most = std::min(most, look > 0 ? look : world_.fractureInterval());
    }
    return std::min(most, BlockPlan::kRim);
}

bool BlockPass::looks(const Span& span) const {
    return world_.breakable() && untilLook(span.step) < span.substeps;
}

void BlockPass::run(const Span& span, const TexelTarget& nodes, const TexelTarget& bonds,
                    const TexelTarget& links) const {
    if (blockCount_ == 0) return;
    gl::bindImage(kNewNodes, nodes.texture());
    gl::bindImage(kNewBonds, bonds.texture());
    gl::bindImage(kNewLinks, links.texture());
    gl::bindTexture(kCellGroups, GL_TEXTURE_BUFFER, blockTexture_);
    program_.use();
    glUniform1i(uniforms_.substeps, span.substeps);
    glUniform1i(uniforms_.pushed, span.pushed);
    glUniform1f(uniforms_.stepInFrame, static_cast<float>(span.stepInFrame));
    glUniform1i(uniforms_.newNodeWatch, span.newNodeWatch);
    glUniform1i(uniforms_.newBondWatch, span.newBondWatch);
    glUniform1i(uniforms_.firstLook, untilLook(span.step));
    glDispatchCompute(static_cast<GLuint>(blockCount_), 1, 1);
    finishImages();
}

}  // namespace sunder::gpu
