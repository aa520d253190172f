// What ObjectPass keeps between two steps, as bytes.
#include <algorithm>
#include <glm/geometric.hpp>

#include "core/archive.hpp"
#include "gpu/object_pass.hpp"

namespace sunder::gpu {

using namespace core;

void ObjectPass::archive(Archive& a, const std::function<bool(int object)>& asleep) {
    a.section("objects");
    Motion motion(static_cast<std::size_t>(SUNDER_OBJECT_LAYERS * count_));
    for (int layer = 0; a.writes() && layer < SUNDER_OBJECT_LAYERS; ++layer) {
        const std::vector<vec4> texels = motion_[current_].read(layer, {0, count_});
        std::copy(texels.begin(), texels.end(), motion.begin() + layer * count_);
    }
    archive(a, motion);
    std::vector<ObjectState> known = known_;
    for (ObjectState& state : known) core::archive(a, state);
    std::vector<Rest> rests = rests_;
    for (Rest& rest : rests) {
        rest.calmSteps = a.whole(rest.calmSteps, 0, 1 << 30);
        rest.disturbed = a.whole<std::int64_t>(rest.disturbed, 0, Archive::kLastStep);
    }
    const auto changed = a.whole<std::int64_t>(changed_, 0, Archive::kLastStep);
    const bool searchDue = a.flag(searchDue_), newWatch = a.flag(newWatch_);
    const int next = a.whole(next_, 0, kLag - 1);
    for (Answer& answer : answers_) archive(a, answer);
    std::vector<Pair> pairs;
    if (a.writes() && !searchDue) pairs = readPairs();
    a.list(pairs, list_.size() / kPairBytes, [&](Pair& pair) { archive(a, pair); });
    if (!a.reads()) return;
    for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer)
        motion_[current_].write(layer, 0,
                                std::span(motion).subspan(static_cast<std::size_t>(layer * count_),
                                                          static_cast<std::size_t>(count_)));
    known_ = std::move(known);
    rests_ = std::move(rests);
    changed_ = changed;
    newWatch_ = newWatch;
    next_ = next;
    for (int object = 0; object < count_; ++object) asleep_[object] = asleep(object);
    writeSleepers();
    writePairs(pairs);
    searchDue_ = searchDue;
}

void ObjectPass::archive(Archive& a, Motion& motion) const {
    for (vec4& texel : motion)
        for (int i = 0; i < 4; ++i) texel[i] = a.real(texel[i]);
    for (int i = 0; !a.writes() && i < count_; ++i) {
        const vec4 &turned = motion[count_ + i], &memory = motion[4 * count_ + i];
        const float length = glm::dot(turned, turned);
        a.require(length > 0.25f && length < 4);  // 1, but for rounding
        a.require(memory.x >= 0 && memory.y >= 0 && memory.z >= 0 &&
                  memory.z <= SUNDER_TOUCHED + SUNDER_HUNG);
    }
}

void ObjectPass::archive(Archive& a, Answer& answer) {
    const auto step = a.whole<std::int64_t>(answer.step, -1, Archive::kLastStep);
    Motion motion(answer.texels.size() / sizeof(vec4));
    if (a.writes() && step >= 0) {
        answer.done.wait();
        answer.texels.read(0, answer.texels.size(), motion.data());
    }
    if (step >= 0) archive(a, motion);
    if (!a.reads()) return;
    answer.step = step;
    answer.texels.write(0, answer.texels.size(), motion.data());
    answer.done = gl::Fence::insert();
}

void ObjectPass::archive(Archive& a, Pair& pair) const {
    pair[0] = a.whole<GLint>(pair[0], 0, world_.cellCount() - 1);
    a.require(world_.present(pair[0]));
    for (GLint* four : {&pair[1], &pair[2]}) {
        *four = a.whole<GLint>(*four, std::numeric_limits<GLint>::min(),
                               std::numeric_limits<GLint>::max());
        for (int i = 0; i < 4; ++i)
            a.require((static_cast<GLuint>(*four) >> 8 * i & 255u) <= static_cast<GLuint>(count_));
    }
    pair[3] = a.whole<GLint>(pair[3], 0, 7);
}

/// The capture itself knows how many they are.
std::vector<ObjectPass::Pair> ObjectPass::readPairs() const {
    const gl::Query generated = gl::makeQuery();
    touches_.bind();  // nothing is drawn, but a draw needs a framebuffer
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginQuery(GL_PRIMITIVES_GENERATED, generated.id());
    drawPairs(listedProgram_);
    glEndQuery(GL_PRIMITIVES_GENERATED);
    glDisable(GL_RASTERIZER_DISCARD);
    GLuint count = 0;
    glGetQueryObjectuiv(generated.id(), GL_QUERY_RESULT, &count);
    std::vector<Pair> pairs(count);
    list_.read(0, kPairBytes * pairs.size(), pairs.data());
    return pairs;
}

void ObjectPass::writePairs(const std::vector<Pair>& pairs) {
    gl::Buffer from(kPairBytes * std::max<std::size_t>(1, pairs.size()), nullptr, GL_STREAM_DRAW,
                    "restored pairs");
    from.write(0, kPairBytes * pairs.size(), pairs.data());
    const gl::VertexArray attributes = gl::makeVertexArray();
    glBindVertexArray(attributes.id());
    pairAttribute(from);
    touches_.bind();
    glEnable(GL_RASTERIZER_DISCARD);
    listedProgram_.use();
    gl::beginCaptures(capture_);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(pairs.size()));
    glEndTransformFeedback();
    gl::endCaptures();
    glDisable(GL_RASTERIZER_DISCARD);
}

}  // namespace sunder::gpu
