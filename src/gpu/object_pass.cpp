#include "gpu/object_pass.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "core/contact.hpp"
#include "core/incident.hpp"
#include "core/object_contact.hpp"
#include "gl/timer.hpp"
#include "gpu/feedback.hpp"
#include "gpu/layout.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

/// Room in the list, for every cell: more objects than that are seldom near one.
constexpr std::size_t kPairsPerCell = 2;

void addBlending() {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
}

std::array<vec4, SUNDER_OBJECT_LAYERS> texelsOf(const Object& object, const ObjectState& state) {
    const double spinEnergy = 0.5 * state.angularMomentum.dot(state.spin(object));
    return {toVec4(state.position, state.present ? 1 : 0),
            toVec4(state.orientation.vec(), state.orientation.w()), toVec4(state.velocity, 0),
            toVec4(state.angularMomentum, spinEnergy), toVec4({state.load, 0, 0}, 0)};
}

Vec3 toVec3(const vec4& v) {
    return {v.x, v.y, v.z};
}

/// `layer(i)`: the object's texel in layer i.
template <class Layer>
ObjectState stateOf(const Layer& layer) {
    ObjectState state;
    state.present = layer(0).w > 0;
    state.position = toVec3(layer(0));
    state.orientation = Eigen::Quaterniond(layer(1).w, layer(1).x, layer(1).y, layer(1).z);
    state.velocity = toVec3(layer(2));
    state.angularMomentum = toVec3(layer(3));
    state.load = layer(4).x;
    return state;
}

/// What has broken off a body that sleeps lies around it.
RestBox wideBoxOf(const Body& body) {
    const Box box = body.bounds();
    const Vec3 around = Vec3::Constant(0.5 * body.size().norm());
    return {0, box.low - around, box.high + around};
}

/// m, from a point to a box.
double distanceTo(const RestBox& box, const Vec3& x) {
    return (x - x.cwiseMax(box.low).cwiseMin(box.high)).norm();
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
      noAttributes_(gl::makeVertexArray()),
      rests_(static_cast<std::size_t>(count_)),
      asleep_(static_cast<std::size_t>(count_), false),
      gains_(static_cast<std::size_t>(count_)),
      sleepers_(sizeof(float) * static_cast<std::size_t>(count_), nullptr, GL_DYNAMIC_DRAW,
                "sleeping objects"),
      sleepersTexture_(gl::makeBufferTexture(sleepers_, GL_R32F, "sleeping objects")),
      sleepSteps_(sleepSteps(world)) {
    const gl::Defines nodes = {{"BUFFERS", storage == ContactPass::Storage::Buffers ? "1" : "0"}};
    searchProgram_ = gl::Program({.vertex = "objects/search.vert",
                                  .geometry = "objects/search.geom",
                                  .defines = nodes,
                                  .feedback = {"pair"}});
    setConstants(searchProgram_, world, columns);
    glUniform1f(searchProgram_.uniform("searchInterval"), static_cast<float>(world.contactTime()));
    glUniform1i(searchProgram_.uniform("objectCount"), count_);
    countProgram_ = pairProgram("COUNT", "", "objects/count.frag", count_, 1);
    reactionProgram_ = pairProgram("REACTION", "", "objects/reaction.frag", count_, 1);
    forceProgram_ =
        storage == ContactPass::Storage::Textures
            ? pairProgram("FORCE", "", "objects/force.frag", columns, rows)
            : pairProgram("FORCE", "objects/force.geom", "scatter/element.frag", columns, rows);
    amongProgram_ = objectProgram("objects/among.frag");
    accelerateProgram_ = objectProgram("objects/accelerate.frag");
    stepInFrameUniform_ = accelerateProgram_.uniform("stepInFrame");
    moveProgram_ = objectProgram("objects/move.frag");
    glUniform3f(moveProgram_.uniform("gravity"), static_cast<float>(world.description().gravity[0]),
                static_cast<float>(world.description().gravity[1]),
                static_cast<float>(world.description().gravity[2]));
    glUniform1f(moveProgram_.uniform("heaviest"), static_cast<float>(massOf(world)));
    newWatchUniform_ = moveProgram_.uniform("newWatch");

    listedProgram_ = gl::Program(
        {.vertex = "objects/pairs.vert", .feedback = {"pair"}, .attributes = {{"listed", 0}}});

    glBindVertexArray(pairs_.id());
    pairAttribute(list_);
    gl::beginCaptures(capture_);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, list_.id());
    gl::endCaptures();
    for (Answer& answer : answers_)
        answer.texels = gl::Buffer(SUNDER_OBJECT_LAYERS * touches_.layerBytes(), nullptr,
                                   GL_STREAM_READ, "where objects are");
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
    glUniform1f(program.uniform("settlingSpeed"), static_cast<float>(settlingSpeed(world_)));
    return program;
}

void ObjectPass::pairAttribute(const gl::Buffer& pairs) {
    glBindBuffer(GL_ARRAY_BUFFER, pairs.id());
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(0, 4, GL_INT, kPairBytes, nullptr);
}

void ObjectPass::set(const State& state) {
    known_ = state.objects;
    std::vector<vec4> texels(static_cast<std::size_t>(count_));
    for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer) {
        for (int i = 0; i < count_; ++i)
            texels[i] = texelsOf(world_.objects()[i], state.objects[i])[layer];
        motion_[current_].write(layer, 0, texels);
    }
    for (Answer& answer : answers_) answer.step = -1;
    std::fill(rests_.begin(), rests_.end(), Rest{});
    std::fill(asleep_.begin(), asleep_.end(), false);
    writeSleepers();
    searchDue_ = newWatch_ = true;
}

void ObjectPass::read(State& state) const {
    std::array<std::vector<vec4>, SUNDER_OBJECT_LAYERS> layers;
    for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer)
        layers[layer] = motion_[current_].read(layer, {0, count_});
    state.objects.clear();
    for (int i = 0; i < count_; ++i)
        state.objects.push_back(stateOf([&](int layer) { return layers[layer][i]; }));
}

void ObjectPass::copy(gl::Buffer& to) const {
    const TexelTarget& motion = motion_[current_];
    if (to.size() == 0)
        to = gl::Buffer(SUNDER_OBJECT_LAYERS * motion.layerBytes(), nullptr, GL_STREAM_READ,
                        "late objects");
    for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer)
        motion.copy(layer, to, static_cast<std::size_t>(layer) * motion.layerBytes());
}

void ObjectPass::read(const gl::Buffer& from, State& state) const {
    std::vector<vec4> texels(from.size() / sizeof(vec4));
    from.read(0, from.size(), texels.data());
    const std::size_t layerTexels = motion_[current_].layerTexels();
    state.objects.clear();
    for (int i = 0; i < count_; ++i)
        state.objects.push_back(
            stateOf([&](int layer) { return texels[layer * layerTexels + i]; }));
}

const gl::Texture& ObjectPass::places() {
    for (int layer = 0; layer < 2; ++layer)
        motion_[current_].copy(layer, places_.buffer(), layer * motion_[current_].layerBytes());
    return *places_.texture();
}

void ObjectPass::put(int object, const ObjectState& state, std::int64_t step) {
    const auto texels = texelsOf(world_.objects()[object], state);
    for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer)
        motion_[current_].write(layer, object, {&texels[layer], 1});
    known_[object] = state;
    setAsleep({object}, false, step);
    changed_ = step;
    searchDue_ = true;
}

void ObjectPass::bind() const {
    gl::bindTexture(kObjects, GL_TEXTURE_BUFFER, buffers_.objects());
    gl::bindTexture(kSleepers, GL_TEXTURE_BUFFER, sleepersTexture_);
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
    gl::beginCaptures(capture_);
    glBeginTransformFeedback(GL_POINTS);
    for (const TexelRange& range : cells_)
        glDrawArrays(GL_POINTS, range.first, range.end - range.first);
    glEndTransformFeedback();
    gl::endCaptures();
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

void ObjectPass::accelerate(int stepInFrame) {
    bind();
    current_ = 1 - current_;
    motion_[current_].bind();
    accelerateProgram_.use();
    glUniform1f(stepInFrameUniform_, static_cast<float>(stepInFrame));
    drawObjects(accelerateProgram_);
    searchDue_ = true;
}

void ObjectPass::push(std::int64_t step) {
    bind();
    if (searchDue_ || step % world_.contactInterval() == 0) search();
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
    moveProgram_.use();
    glUniform1i(newWatchUniform_, std::exchange(newWatch_, false));
    drawObjects(moveProgram_);
}

void ObjectPass::look(std::int64_t step, int steps) {
    Answer& answer = answers_[next_];
    next_ = (next_ + 1) % kLag;
    if (answer.step >= changed_) {  // an older one does not know of it
        answer.done.wait();
        std::vector<vec4> texels(answer.texels.size() / sizeof(vec4));
        answer.texels.read(0, answer.texels.size(), texels.data());
        take(texels, answer.step - steps, steps);
    }
    for (int layer = 0; layer < SUNDER_OBJECT_LAYERS; ++layer)
        motion_[current_].copy(layer, answer.texels, layer * motion_[current_].layerBytes());
    answer.done = gl::Fence::insert();
    answer.step = step;
    newWatch_ = true;
}

/// texels: what the `steps` steps from `since` on came to.
void ObjectPass::take(const std::vector<vec4>& texels, std::int64_t since, int steps) {
    for (int i = 0; i < count_; ++i) {
        const auto layer = [&](int number) { return texels[number * count_ + i]; };
        known_[i] = stateOf(layer);
        const int had = static_cast<int>(layer(4).z);
        const ObjectUnrest unrest{layer(4).y, (had & SUNDER_TOUCHED) != 0,
                                  (had & SUNDER_HUNG) != 0};
        Rest& rest = rests_[i];
        rest.calmSteps = rest.disturbed <= since && calm(unrest) ? rest.calmSteps + steps : 0;
    }
}

RestIslands::Status ObjectPass::restStatus(int object) const {
    using Status = RestIslands::Status;
    if (!known_[object].present || world_.objects()[object].inverseMass == 0) return Status::Apart;
    if (asleep_[object]) return Status::Asleep;
    return rests_[object].calmSteps >= sleepSteps_ ? Status::Ready : Status::Restless;
}

void ObjectPass::setAsleep(const std::vector<int>& objects, bool asleep, std::int64_t step) {
    constexpr vec4 zero(0);
    for (const int object : objects) {
        asleep_[object] = asleep;
        rests_[object] = {0, step};
        if (!asleep) continue;
        known_[object].velocity.setZero();
        known_[object].angularMomentum.setZero();
        for (const int layer : {2, 3}) motion_[current_].write(layer, object, {&zero, 1});
    }
    writeSleepers();
}

void ObjectPass::writeSleepers() {
    std::vector<float> flags;
    for (const bool asleep : asleep_) flags.push_back(asleep ? 1.f : 0.f);
    sleepers_.write(0, sizeof(float) * flags.size(), flags.data());
}

double ObjectPass::speedOf(int index) const {
    const Object& object = world_.objects()[index];
    return known_[index].velocity.norm() + known_[index].spin(object).norm() * object.reach();
}

void ObjectPass::expect(const EventSchedule& events, std::int64_t step) {
    std::fill(gains_.begin(), gains_.end(), 0.0);
    const int look = stepsPerLook(world_);
    const std::int64_t from = std::max<std::int64_t>(0, step - (kLag + 1) * look), to = step + look;
    if (events.nextBlast(from) >= to) return;
    for (const int index : events.blasts()) {
        const Event& blast = events.all()[index];
        const double steps = std::min(blast.end, static_cast<double>(to)) -
                             std::max(blast.start, static_cast<double>(from));
        if (steps <= 0) continue;
        const double most = blast.acceleration.norm() + std::abs(blast.outward);
        for (int object = 0; object < count_; ++object) {
            if (!known_[object].present || world_.objects()[object].inverseMass == 0) continue;
            const Vec3 way = Vec3::Constant(reachOf(object));
            if (blast.reaches(known_[object].position - way, known_[object].position + way))
                gains_[object] += steps * world_.step() * most;
        }
    }
}

bool ObjectPass::anyAwake() const {
    for (int i = 0; i < count_; ++i)
        if (known_[i].present &&
            (world_.objects()[i].inverseMass > 0 ? !asleep_[i] : speedOf(i) > 0))
            return true;
    return false;
}

bool ObjectPass::stirs(int object) const {
    return known_[object].present && !asleep_[object] &&
           speedOf(object) + gains_[object] > kStirringSpeed;
}

double ObjectPass::reachOf(int object) const {
    // Two looks ago, and until the next one.
    constexpr double time = (kLag + 1) / 60.0;
    const double fall = world_.description().gravity.norm() * time;
    return world_.objects()[object].reach() +
           (known_[object].velocity.norm() + gains_[object] + fall) * time;
}

bool ObjectPass::threatens(int body) const {
    const RestBox box = wideBoxOf(world_.bodies()[body]);
    for (int i = 0; i < count_; ++i)
        if (stirs(i) && distanceTo(box, known_[i].position) < reachOf(i)) return true;
    return false;
}

bool ObjectPass::threatensObject(int object) const {
    for (int i = 0; i < count_; ++i)
        if (i != object && stirs(i) &&
            (known_[i].position - known_[object].position).norm() <
                reachOf(i) + world_.objects()[object].reach())
            return true;
    return false;
}

bool ObjectPass::threatenedBy(int object, const RestBox& box, double speed) const {
    if (speed <= kStirringSpeed) return false;
    const double time = (kLag + 1) / 60.0, fall = world_.description().gravity.norm() * time;
    return distanceTo(box, known_[object].position) <
           world_.objects()[object].reach() + (speed + fall) * time;
}

}  // namespace sunder::gpu
