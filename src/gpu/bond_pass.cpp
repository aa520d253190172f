#include "gpu/bond_pass.hpp"

#include <algorithm>
#include <cstddef>

#include "gpu/layout.hpp"

namespace sunder::gpu {

BondPass::BondPass(const World& world, const char* fractureShader)
    : cellCount_(world.cellCount()),
      fractureProgram_({.vertex = fractureShader,
                        .feedback = {"newDamage", "newSlow"},
                        .attributes = {{"damage", 0}, {"slow", 1}, {"strength", 2}}}),
      linkProgram_({.vertex = "physics/links.vert",
                    .feedback = {"newMasks", "newInverseMassLow", "newInverseMassHigh"}}),
      linkBuffer_(sizeof(LinkRecord) * world.cellCount(), nullptr, GL_DYNAMIC_COPY, "links"),
      linkTexture_(gl::makeBufferTexture(linkBuffer_, GL_RGBA32UI, "links")),
      bonds_{{{BondBuffer(world), gl::makeVertexArray()},
              {BondBuffer(world), gl::makeVertexArray()}}} {
    std::vector<vec4> strengths(cellCount_, vec4(0));
    for (int cell = 0; cell < cellCount_; ++cell)
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            const float strength = world.bondStrength(kBondsPerCell * cell + axis);
            breakable_ |= strength < static_cast<float>(SUNDER_UNBREAKABLE);
            strengths[cell][axis] = std::min(strength, static_cast<float>(SUNDER_UNBREAKABLE));
        }
    for (const sunder::ElementLaw& law : world.laws())
        breakable_ |= law.maxStress < SUNDER_UNBREAKABLE;
    strengthBuffer_ = gl::makeBuffer<vec4>(strengths, GL_STATIC_DRAW, "bond strengths");
    for (const Side& side : bonds_) {
        glBindVertexArray(side.attributes.id());
        glBindBuffer(GL_ARRAY_BUFFER, side.bonds.buffer().id());
        floatAttribute(0, 4, sizeof(BondRecord), offsetof(BondRecord, damage));
        floatAttribute(1, 4, sizeof(BondRecord), offsetof(BondRecord, slow));
        glBindBuffer(GL_ARRAY_BUFFER, strengthBuffer_.id());
        floatAttribute(2, 4, sizeof(vec4), 0);
    }
    setConstants(fractureProgram_, world);
    setConstants(linkProgram_, world);
}

void BondPass::update(const Feedback& feedback) {
    const int next = 1 - current_;
    feedback.run(fractureProgram_, bonds_[current_].attributes, {&bonds_[next].bonds.buffer()}, 0,
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
