#include "gpu/bond_pass.hpp"

#include <cstddef>

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
      bonds_{{{BondBuffer(world), gl::makeVertexArray()},
              {BondBuffer(world), gl::makeVertexArray()}}} {
    for (const Side& side : bonds_) {
        glBindVertexArray(side.attributes.id());
        glBindBuffer(GL_ARRAY_BUFFER, side.bonds.buffer().id());
        floatAttribute(0, 4, sizeof(BondRecord), offsetof(BondRecord, damage));
        floatAttribute(1, 4, sizeof(BondRecord), offsetof(BondRecord, slow));
    }
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
