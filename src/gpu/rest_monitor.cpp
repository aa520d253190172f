#include "gpu/rest_monitor.hpp"

#include <algorithm>
#include <cmath>

#include "core/sleep.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {
namespace {

constexpr int kCellsPerChunk = 16;

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

RestMonitor::RestMonitor(const World& world, int columns)
    : world_(world),
      interval_(std::max(1, static_cast<int>(std::lround(1 / (60 * world.step()))))),
      sleepSteps_(sleepSteps(world)),
      all_(1, "chunk ranges"),
      chunkBuffer_(gl::makeBuffer<GLuint>(chunksOf(world), GL_STATIC_DRAW, "chunks")),
      chunkTexture_(gl::makeBufferTexture(chunkBuffer_, GL_RG32UI, "chunks")),
      unrest_(countChunks(world), columns, 1, "unrest"),
      program_({.vertex = "gather/texels.vert", .fragment = "gather/rest.frag"}) {
    setConstants(program_, world, columns);
    unrest_.prepare(program_);
    int chunk = 0;
    for (const sunder::Body& body : world.bodies()) {
        const auto speed = static_cast<float>(calmSpeed(body));
        bodies_.push_back({{chunk, chunk + countChunks(body)}, speed * speed});
        chunk = bodies_.back().chunks.end;
    }
    const TexelRange every{0, chunk};
    all_.set({&every, 1}, columns);
    for (Answer& answer : answers_)
        answer.texels = gl::Buffer(unrest_.layerBytes(), nullptr, GL_STREAM_READ, "unrest");
}

void RestMonitor::disturb(int body, std::int64_t step) {
    bodies_[body].calmSteps = 0;
    bodies_[body].disturbed = step;
}

std::vector<int> RestMonitor::look(std::int64_t step) {
    Answer& answer = answers_[next_];
    next_ = (next_ + 1) % kLag;
    std::vector<int> calm;
    if (answer.step >= 0 && answer.step < step) calm = take(answer, step);
    ask(answer, step);
    return calm;
}

void RestMonitor::ask(Answer& answer, std::int64_t step) {
    gl::bindTexture(kChunks, GL_TEXTURE_BUFFER, chunkTexture_);
    unrest_.fill(program_, all_);
    unrest_.copy(0, answer.texels);
    answer.done = gl::Fence::insert();
    answer.step = step;
}

std::vector<int> RestMonitor::take(const Answer& answer, std::int64_t now) {
    answer.done.wait();
    std::vector<vec4> unrest(answer.texels.size() / sizeof(vec4));
    answer.texels.read(0, answer.texels.size(), unrest.data());
    std::vector<int> calm;
    const std::int64_t since = answer.step - interval_;
    for (int index = 0; index < static_cast<int>(bodies_.size()); ++index) {
        Body& body = bodies_[index];
        const bool quiet = body.disturbed <= since && !pushedWithin(world_, index, since, now) &&
                           std::all_of(unrest.begin() + body.chunks.first,
                                       unrest.begin() + body.chunks.end, [&](const vec4& chunk) {
                                           return chunk.x < body.calmSpeed2 && chunk.y == 0;
                                       });
        body.calmSteps = quiet ? body.calmSteps + interval_ : 0;
        if (body.calmSteps >= sleepSteps_) calm.push_back(index);
    }
    return calm;
}

}  // namespace sunder::gpu
