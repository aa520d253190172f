#include "gpu/rest_monitor.hpp"

#include <algorithm>
#include <cmath>

#include "core/incident.hpp"
#include "core/sleep.hpp"
#include "gpu/contact_pass.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

constexpr int kCellsPerChunk = kCellsPerRestBox;
constexpr std::int64_t kRestHasteUnit = 16384;  ///< glsl/gather/rest.frag

/// First cell and number of cells of every chunk; a chunk lies within one body.
std::vector<GLuint> chunksOf(const World& world) {
    std::vector<GLuint> chunks;
    for (const Body& body : world.bodies())
        for (int cell = 0; cell < body.cellCount(); cell += kCellsPerChunk) {
            chunks.push_back(static_cast<GLuint>(body.firstCell + cell));
            chunks.push_back(
                static_cast<GLuint>(std::min(kCellsPerChunk, body.cellCount() - cell)));
        }
    return chunks;
}

int countChunks(const Body& body) {
    return (body.cellCount() + kCellsPerChunk - 1) / kCellsPerChunk;
}

int countChunks(const World& world) {
    int count = 0;
    for (const Body& body : world.bodies()) count += countChunks(body);
    return count;
}

}  // namespace

RestMonitor::RestMonitor(const World& world, int columns, const EventSchedule& events)
    : world_(world),
      events_(events),
      interval_(stepsPerLook(world)),
      sleepSteps_(sleepSteps(world)),
      layers_(world.description().contact ? 3 : 1),
      all_(1, "chunk ranges"),
      chunkBuffer_(gl::makeBuffer<GLuint>(chunksOf(world), GL_STATIC_DRAW, "chunks")),
      chunkTexture_(gl::makeBufferTexture(chunkBuffer_, GL_RG32UI, "chunks")),
      unrest_(countChunks(world), columns, layers_, "unrest"),
      program_(unrest_.program(world, "gather/rest.frag",
                               {{"CONTACT", world.description().contact ? "1" : "0"}})) {
    int chunk = 0;
    for (const sunder::core::Body& body : world.bodies()) {
        bodies_.push_back({{chunk, chunk + countChunks(body)}});
        setBody(static_cast<int>(bodies_.size()) - 1, true, false);
        chunk = bodies_.back().chunks.end;
    }
    const TexelRange every{0, chunk};
    all_.set({&every, 1}, columns);
    for (Answer& answer : answers_)
        answer.texels = gl::Buffer(static_cast<std::size_t>(layers_) * unrest_.layerBytes(),
                                   nullptr, GL_STREAM_READ, "unrest");
}

void RestMonitor::setBody(int index, bool present, bool released) {
    const core::Body& of = world_.bodies()[index];
    const auto calm = static_cast<float>(calmSpeed(world_, of, released)),
               creep = static_cast<float>(creepSpeed(world_, of, released));
    Body& body = bodies_[index];
    body.present = present;
    body.calmSpeed2 = calm * calm;
    body.creepSpeed2 = creep * creep;
}

void RestMonitor::disturb(int body, std::int64_t step) {
    bodies_[body].calmSteps = 0;
    bodies_[body].disturbed = step;
}

void RestMonitor::archive(Archive& a) {
    a.section("calm");
    std::vector<Body> bodies = bodies_;
    for (Body& body : bodies) {
        body.calmSteps = a.whole(body.calmSteps, 0, 1 << 30);
        body.disturbed = a.whole<std::int64_t>(body.disturbed, 0, Archive::kLastStep);
    }
    std::vector<Chunk> known = known_;
    a.list(known, static_cast<std::size_t>(bodies.back().chunks.end), [&](Chunk& chunk) {
        chunk.box.member =
            a.whole(chunk.box.member, 0, memberOfBody(static_cast<int>(bodies.size()) - 1));
        chunk.box.low = a.vector(chunk.box.low);
        chunk.box.high = a.vector(chunk.box.high);
        chunk.fastest = a.real(chunk.fastest, 0.);
    });
    const int next = a.whole(next_, 0, kLag - 1);
    for (Answer& answer : answers_) archive(a, answer);
    if (!a.reads()) return;
    bodies_ = std::move(bodies);
    known_ = std::move(known);
    next_ = next;
}

void RestMonitor::archive(Archive& a, Answer& answer) {
    const auto step = a.whole<std::int64_t>(answer.step, -1, Archive::kLastStep);
    std::vector<vec4> unrest(answer.texels.size() / sizeof(vec4), vec4(0));
    if (a.writes() && step >= 0) {
        answer.done.wait();
        answer.texels.read(0, answer.texels.size(), unrest.data());
    }
    const auto chunks = static_cast<std::size_t>(bodies_.back().chunks.end);
    for (std::size_t chunk = 0; step >= 0 && chunk < chunks; ++chunk) {
        vec4& some = unrest[chunk];
        some.x = a.real(some.x, 0.f);
        some.y = a.real(some.y, 0.f, 1.f);
        some.z = a.real(some.z, 0.f, static_cast<float>(bodies_.size() + 1));
        some.w = a.real(some.w, 0.f, 256.f * kRestHasteUnit);
        for (int layer = 1; layer < layers_; ++layer) {
            vec4& corner = unrest[static_cast<std::size_t>(layer) * unrest_.layerTexels() + chunk];
            for (int axis = 0; axis < 3; ++axis) corner[axis] = a.real(corner[axis]);
        }
    }
    if (!a.reads()) return;
    answer.step = step;
    answer.texels.write(0, answer.texels.size(), unrest.data());
    answer.done = gl::Fence::insert();
}

RestMonitor::News RestMonitor::look(std::int64_t step) {
    Answer& answer = answers_[next_];
    next_ = (next_ + 1) % kLag;
    News news;
    if (answer.step >= 0 && answer.step < step) news = take(answer, step);
    ask(answer, step);
    return news;
}

void RestMonitor::ask(Answer& answer, std::int64_t step) {
    gl::bindTexture(kChunks, GL_TEXTURE_BUFFER, chunkTexture_);
    unrest_.fill(program_, all_);
    for (int layer = 0; layer < layers_; ++layer)
        unrest_.copy(layer, answer.texels, static_cast<std::size_t>(layer) * unrest_.layerBytes());
    answer.done = gl::Fence::insert();
    answer.step = step;
}

RestMonitor::News RestMonitor::take(const Answer& answer, std::int64_t now) {
    answer.done.wait();
    std::vector<vec4> unrest(answer.texels.size() / sizeof(vec4));
    answer.texels.read(0, answer.texels.size(), unrest.data());
    News news;
    news.haste.resize(bodies_.size(), 1);
    const std::int64_t since = answer.step - interval_;
    for (int index = 0; index < static_cast<int>(bodies_.size()); ++index) {
        Body& body = bodies_[index];
        if (!body.present) continue;
        vec4 all(0);
        for (int chunk = body.chunks.first; chunk < body.chunks.end; ++chunk) {
            const vec4& some = unrest[chunk];
            all = {std::max(all.x, some.x), std::max(all.y, some.y), std::max(all.z, some.z), 0};
            const auto leftOut = std::llround(some.w);
            news.dropped += leftOut % kRestHasteUnit;
            news.haste[index] = std::max(news.haste[index], hasteOf(leftOut / kRestHasteUnit));
            if (some.z >= 2) news.hit.push_back(static_cast<int>(some.z) - 2);
        }
        const float limit = all.z > 0 ? body.creepSpeed2 : body.calmSpeed2;
        const bool quiet = body.disturbed <= since &&
                           !events_.pushedWithin(index, since, now + 1) && all.x < limit &&
                           all.y == 0;
        body.calmSteps = quiet ? body.calmSteps + interval_ : 0;
    }
    takeChunks(unrest);
    return news;
}

void RestMonitor::takeChunks(const std::vector<vec4>& unrest) {
    known_.clear();
    if (layers_ == 1) return;
    const std::size_t layer = unrest_.layerTexels();
    for (int index = 0; index < static_cast<int>(bodies_.size()); ++index) {
        if (!bodies_[index].present) continue;
        const double reach = restReach(world_.bodies()[index]);
        for (int chunk = bodies_[index].chunks.first; chunk < bodies_[index].chunks.end; ++chunk) {
            const vec4 &low = unrest[layer + chunk], &high = unrest[2 * layer + chunk];
            if (low.x > high.x) continue;  // all its cells are absent
            known_.push_back(
                {{memberOfBody(index), Vec3(low.x - reach, low.y - reach, low.z - reach),
                  Vec3(high.x + reach, high.y + reach, high.z + reach)},
                 std::sqrt(unrest[chunk].x)});
        }
    }
}

}  // namespace sunder::gpu
