#include "gpu/object_pass.hpp"

#include <algorithm>

#include "core/contact.hpp"
#include "core/sleep.hpp"
#include "gpu/feedback.hpp"
#include "gpu/layout.hpp"

namespace sunder::gpu {
namespace {

/// Room in the list, for every cell: more objects than that are seldom near one.
constexpr std::size_t kPairsPerCell = 2;
constexpr std::size_t kPairBytes = 4 * sizeof(GLint);

void addBlending() {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
}

std::array<vec4, SUNDER_OBJECT_LAYERS> texelsOf(const ObjectState& state) {
    return {toVec4(state.position, state.present ? 1 : 0),
            toVec4(state.orientation.vec(), state.orientation.w()), toVec4(state.velocity, 0),
            toVec4(state.angularMomentum, 0)};
}

Vec3 toVec3(const vec4& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

ObjectPass::ObjectPass(const World& world, const WorldBuffers& buffers,
                       ContactPass::Storage storage, int columns, int rows)
    : world_(world),
      buffers_(buffers),
      storage_(storage),
      columns_(columns),
      count_(static_cast<int>(world.objects().size())),
      motion_{TexelTarget(count_, count_, SUNDER_OBJECT_LAYERS, "objects"),
              TexelTarget(count_, count_, SUNDER_OBJECT_LAYERS, "objects")},
      touches_(count_, count_, 1, "object touches"),
      impulses_(count_, count_, 2, "object impulses"),
      places_(world),
      list_(kPairBytes * (kPairsPerCell * static_cast<std::size_t>(world.cellCount()) + 1024),
            nullptr, GL_DYNAMIC_COPY, "cells near objects"),
      capture_(gl::makeTransformFeedback()),
      pairs_(gl::makeVertexArray()),
      noAttributes_(gl::makeVertexArray()) {
    const gl::Defines nodes = {{"BUFFERS", storage == ContactPass::Storage::Buffers ? "1" : "0"}};
    searchProgram_ = gl::Program({.vertex = "objects/search.vert",
                                  .geometry = "objects/search.geom",
                                  .defines = nodes,
                                  .feedback = {"pair"}});
    setConstants(searchProgram_, world, columns);
    glUniform1f(searchProgram_.uniform("searchInterval"),
                static_cast<float>(kContactInterval * world.step()));
    glUniform1i(searchProgram_.uniform("objectCount"), count_);
    countProgram_ = pairProgram("COUNT", "", "objects/count.frag", count_, 1);
    reactionProgram_ = pairProgram("REACTION", "", "objects/reaction.frag", count_, 1);
    forceProgram_ =
        storage == ContactPass::Storage::Textures
            ? pairProgram("FORCE", "", "objects/force.frag", columns, rows)
            : pairProgram("FORCE", "objects/force.geom", "scatter/element.frag", columns, rows);
    amongProgram_ = objectProgram("objects/among.frag");
    moveProgram_ = objectProgram("objects/move.frag");
    glUniform3f(moveProgram_.uniform("gravity"), static_cast<float>(world.description().gravity[0]),
                static_cast<float>(world.description().gravity[1]),
                static_cast<float>(world.description().gravity[2]));

    glBindVertexArray(pairs_.id());
    glBindBuffer(GL_ARRAY_BUFFER, list_.id());
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(0, 4, GL_INT, kPairBytes, nullptr);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, capture_.id());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, list_.id());
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    for (Answer& answer : answers_)
        answer.texels = gl::Buffer(kLooked.size() * touches_.layerBytes(), nullptr, GL_STREAM_READ,
                                   "where objects are");
}

gl::Program ObjectPass::pairProgram(const char* what, const char* geometry, const char* fragment,
                                    int columns, int rows) const {
    gl::Program program(
        {.vertex = "objects/pair.vert",
         .geometry = geometry,
         .fragment = fragment,
         .defines = {{"BUFFERS", storage_ == ContactPass::Storage::Buffers ? "1" : "0"},
                     {"WHAT", what},
                     {"FRACTURE", "0"}},
         .attributes = {{"pair", 0}}});
    setConstants(program, world_, columns_);
    glUniform2i(program.uniform("targetSize"), columns, rows);
    glUniform1f(program.uniform("targetHeight"), static_cast<float>(rows));
    glUniform1i(program.uniform("objectCount"), count_);
    return program;
}

gl::Program ObjectPass::impulseProgram(const TexelTarget& target) const {
    return pairProgram("IMPULSE", "", "objects/impulse.frag", target.columns(), target.rows());
}

gl::Program ObjectPass::objectProgram(const char* fragment) const {
    gl::Program program({.vertex = "objects/all.vert",
                         .fragment = fragment,
                         .defines = {{"ROOM", world_.description().room ? "1" : "0"}}});
    setConstants(program, world_, columns_);
    glUniform1i(program.uniform("objectCount"), count_);
    return program;
}

void ObjectPass::set(const State& state) {
    known_ = state.objects;
    std::vector<vec4> texels(static_cast<std::size_t>(count_));
    for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer) {
        for (int i = 0; i < count_; ++i) texels[i] = texelsOf(state.objects[i])[layer];
        motion_[current_].write(layer, 0, texels);
    }
    for (Answer& answer : answers_) answer.step = -1;
    searchDue_ = true;
}

void ObjectPass::read(State& state) const {
    std::array<std::vector<vec4>, SUNDER_OBJECT_LAYERS> layers;
    for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer)
        layers[layer] = motion_[current_].read(layer, {0, count_});
    state.objects.resize(static_cast<std::size_t>(count_));
    for (int i = 0; i < count_; ++i) {
        ObjectState& object = state.objects[i];
        object.present = layers[0][i].w > 0;
        object.position = toVec3(layers[0][i]);
        object.orientation =
            Eigen::Quaterniond(layers[1][i].w, layers[1][i].x, layers[1][i].y, layers[1][i].z);
        object.velocity = toVec3(layers[2][i]);
        object.angularMomentum = toVec3(layers[3][i]);
    }
}

const gl::Texture& ObjectPass::places() {
    for (int layer = 0; layer < 2; ++layer)
        motion_[current_].copy(layer, places_.buffer(), layer * motion_[current_].layerBytes());
    return *places_.texture();
}

bool ObjectPass::startStep(std::int64_t step) {
    bool any = false;
    for (const Throw& thrown : world_.throws()) {
        if (thrown.step != step) continue;
        const auto texels = texelsOf(thrown.state);
        bind();  // writing unbinds the texture of the active unit: let it be this one
        for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer)
            motion_[current_].write(layer, thrown.object, {&texels[layer], 1});
        known_[thrown.object] = thrown.state;
        thrown_ = step;
        searchDue_ = any = true;
    }
    return any;
}

void ObjectPass::bind() const {
    gl::bindTexture(kObjects, GL_TEXTURE_BUFFER, buffers_.objects());
    gl::bindTexture(kMotion, GL_TEXTURE_2D_ARRAY, motion_[current_].texture());
}

void ObjectPass::setCells(std::span<const TexelRange> cells) {
    cells_.assign(cells.begin(), cells.end());
    searchDue_ = true;
}

void ObjectPass::search() {
    touches_.bind();  // nothing is drawn, but a draw needs a framebuffer
    glEnable(GL_RASTERIZER_DISCARD);
    searchProgram_.use();
    glBindVertexArray(noAttributes_.id());
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, capture_.id());
    glBeginTransformFeedback(GL_POINTS);
    for (const TexelRange& range : cells_)
        glDrawArrays(GL_POINTS, range.first, range.end - range.first);
    glEndTransformFeedback();
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    glDisable(GL_RASTERIZER_DISCARD);
    searchDue_ = false;
}

void ObjectPass::drawPairs(const gl::Program& program) const {
    program.use();
    glBindVertexArray(pairs_.id());
    glDrawTransformFeedback(GL_POINTS, capture_.id());
}

void ObjectPass::drawObjects(const gl::Program& program) const {
    program.use();
    glBindVertexArray(noAttributes_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ObjectPass::push(std::int64_t step) {
    bind();
    if (searchDue_ || step % kContactInterval == 0) search();
    touches_.bind();
    drawObjects(amongProgram_);
    addBlending();
    drawPairs(countProgram_);
    gl::bindTexture(kTouchCounts, GL_TEXTURE_2D_ARRAY, touches_.texture());
    impulses_.bind();
    constexpr GLfloat zero[] = {0, 0, 0, 0};
    for (GLint layer = 0; layer < 2; ++layer) glClearBufferfv(GL_COLOR, layer, zero);
    drawPairs(reactionProgram_);
    glDisable(GL_BLEND);
    gl::bindTexture(kImpulses, GL_TEXTURE_2D_ARRAY, impulses_.texture());
}

void ObjectPass::drawForces() const {
    addBlending();
    drawPairs(forceProgram_);
    glDisable(GL_BLEND);
}

void ObjectPass::move() {
    current_ = 1 - current_;
    motion_[current_].bind();
    drawObjects(moveProgram_);
}

void ObjectPass::look(std::int64_t step) {
    Answer& answer = answers_[next_];
    next_ = (next_ + 1) % kLag;
    if (answer.step >= thrown_) {  // an older one does not know of the throw
        answer.done.wait();
        std::vector<vec4> texels(answer.texels.size() / sizeof(vec4));
        answer.texels.read(0, answer.texels.size(), texels.data());
        for (int i = 0; i < count_; ++i) {
            known_[i].present = texels[i].w > 0;
            known_[i].position = toVec3(texels[i]);
            known_[i].velocity = toVec3(texels[count_ + i]);
            known_[i].angularMomentum = toVec3(texels[2 * count_ + i]);
        }
    }
    std::size_t offset = 0;
    for (const int layer : kLooked) {
        motion_[current_].copy(layer, answer.texels, offset);
        offset += motion_[current_].layerBytes();
    }
    answer.done = gl::Fence::insert();
    answer.step = step;
}

double ObjectPass::speedOf(int index) const {
    const Object& object = world_.objects()[index];
    const double spin =
        known_[index].angularMomentum.norm() * object.inverseInertia.maxCoeff();  // at most
    return known_[index].velocity.norm() + spin * object.reach();
}

bool ObjectPass::stirring() const {
    for (int i = 0; i < count_; ++i)
        if (present(i) && speedOf(i) > kStirringSpeed) return true;
    return false;
}

bool ObjectPass::threatens(int index) const {
    const Body& body = world_.bodies()[index];
    const Vec3 size = body.cellSize.cwiseProduct(body.cells.cast<double>());
    // What has broken off a body that sleeps lies around it.
    const Vec3 around = Vec3::Constant(0.5 * size.norm());
    const Vec3 low = body.origin - around, high = body.origin + size + around;
    // Two looks ago, and until the next one.
    const double time = (kLag + 1) / 60.0;
    for (int i = 0; i < count_; ++i) {
        const double speed = speedOf(i);
        if (!present(i) || speed <= kStirringSpeed) continue;
        const double reach = world_.objects()[i].reach() +
                             (speed + world_.description().gravity.norm() * time) * time;
        const Vec3 nearest = known_[i].position.cwiseMax(low).cwiseMin(high);
        if ((known_[i].position - nearest).norm() < reach) return true;
    }
    return false;
}

}  // namespace sunder::gpu
