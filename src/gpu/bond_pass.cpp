#include "gpu/bond_pass.hpp"

#include <cstddef>

#include "gl/vertex_array.hpp"
#include "gpu/layout.hpp"

namespace sunder::gpu {

using namespace core;

BondPass::BondPass(const World& world, int textureColumns)
    : cellCount_(world.cellCount()),
      fractureProgram_({.vertex = "scatter/fracture.vert",
                        .feedback = {"newDamage", "newSlow"},
                        .attributes = {{"damage", 0}, {"slow", 1}}}),
      linkProgram_({.vertex = "scatter/links.vert",
                    .feedback = {"newMasks", "newInverseMassLow", "newInverseMassHigh"}}),
      linkBuffer_(sizeof(LinkRecord) * world.cellCount(), nullptr, GL_DYNAMIC_COPY, "links"),
      linkTexture_(gl::makeBufferTexture(linkBuffer_, GL_RGBA32F, "links")),
      bonds_{{{BondBuffer(world), {}}, {BondBuffer(world), {}}}} {
    for (Side& side : bonds_)
        side.attributes = gl::makeVertexArray({{side.bonds.buffer(),
                                                sizeof(BondRecord),
                                                {{0, 4, GL_FLOAT, offsetof(BondRecord, damage)},
                                                 {1, 4, GL_FLOAT, offsetof(BondRecord, slow)}}}});
    setConstants(fractureProgram_, world, textureColumns);
    setConstants(linkProgram_, world, textureColumns);
}

void BondPass::update(const Feedback& feedback) {
    const int next = 1 - current_;
    gl::bindTexture(kBonds, GL_TEXTURE_BUFFER, bonds_[current_].bonds.texture());
    feedback.run(fractureProgram_, bonds_[current_].attributes, {&bonds_[next].bonds.buffer()},
                 cellCount_);
    current_ = next;
    updateLinks(feedback);
}

void BondPass::write(const State& state, const Feedback& feedback) {
    bonds_[current_].bonds.write(state);
    updateLinks(feedback);
}

void BondPass::updateLinks(const Feedback& feedback) {
    gl::bindTexture(kBonds, GL_TEXTURE_BUFFER, bonds_[current_].bonds.texture());
    feedback.run(linkProgram_, {&linkBuffer_}, cellCount_);
}

}  // namespace sunder::gpu
