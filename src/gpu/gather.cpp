#include "gpu/gather.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/archive.hpp"
#include "core/sleep.hpp"
#include "gpu/body_ranges.hpp"
#include "gpu/observed_pass.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

gl::Defines breakDefines(const World& world) {
    return {{"BONDS_BREAK", world.bondsBreak() ? "1" : "0"},
            {"CELLS_BREAK", world.cellsBreak() ? "1" : "0"}};
}

/// kStressLayers of glsl/gather/stress.glsl.
int stressLayers(const World& world) {
    return 6 * world.bondsBreak() + world.cellsBreak();
}

}  // namespace

GatherSolver::GatherSolver(const World& world, const WorldBuffers& buffers)
    : world_(world),
      buffers_(buffers),
      breakable_(world.breakable()),
      columns_(texelColumns(world.cellCount())),
      events_(world),
      nodes_{TexelTarget(world.cellCount(), columns_, 2 * kCorners, "nodes"),
             TexelTarget(world.cellCount(), columns_, 2 * kCorners, "nodes")},
      bonds_{TexelTarget(world.cellCount(), columns_, 2, "bonds"),
             TexelTarget(world.cellCount(), columns_, 2, "bonds")},
      forces_(world.cellCount(), columns_, kCorners, "forces"),
      links_(world.cellCount(), columns_, SUNDER_LINK_TEXELS, "links"),
      forceProgram_(forces_.program(world, "gather/element.frag", {{"STRESSES", "0"}})),
      linkProgram_(links_.program(world, "gather/links.frag")),
      plainNodes_(nodePass("0")),
      pushedNodes_(nodePass("1")),
      stillBondProgram_(bonds_[0].program(world, "gather/still.frag", {{"NODES", "0"}})),
      stillNodePrograms_{
          nodes_[0].program(world, "gather/still.frag", {{"NODES", "1"}, {"FIRST", "0"}}),
          nodes_[0].program(world, "gather/still.frag", {{"NODES", "1"}, {"FIRST", "4"}})},
      book_(world),
      released_(world),
      awake_(world.bodies().size(), "awake cells"),
      monitor_(world, columns_, events_.schedule()) {
    if (breakable_) {
        const gl::Defines defines = breakDefines(world);
        stressProgram_ =
            nodes_[0].program(world, "gather/element.frag", gl::with(defines, "STRESSES", "1"));
        bondProgram_ = bonds_[0].program(world, "gather/fracture.frag", defines);
        bondWatchUniform_ = bondProgram_.uniform("newWatch");
    }
    if (world.description().contact)
        contact_.emplace(world, columns_, ContactPass::Storage::Textures);
    if (!world.objects().empty())
        objects_.emplace(world, buffers, ContactPass::Storage::Textures, columns_, forces_.rows());
    setState(world.initialState());
}

GatherSolver::NodePass GatherSolver::nodePass(const char* events) const {
    NodePass pass;
    constexpr const char* first[kNodeParts] = {"0", "4"};
    for (std::size_t part = 0; part < kNodeParts; ++part) {
        gl::Program& program = pass.programs[part];
        program = nodes_[0].program(world_, "gather/node.frag",
                                    {{"EVENTS", events},
                                     {"ROOM", world_.description().room ? "1" : "0"},
                                     {"FIRST", first[part]}});
        pass.newWatch[part] = program.uniform("newWatch");
        pass.stepInFrame[part] = program.uniform("stepInFrame");
    }
    return pass;
}

State GatherSolver::outline() const {
    State state = world_.initialState();
    state.step = step_;
    state.pushes = events_.schedule().added(step_);
    book_.describe(state);
    return state;
}

State GatherSolver::state() const {
    State state = outline();
    read({0, world_.cellCount()}, state);
    if (objects_) objects_->read(state);
    return state;
}

class GatherSolver::LateState : public StateCopy {
  public:
    explicit LateState(const GatherSolver& solver)
        : solver_(solver),
          cells_(kLayers * solver.nodes_[0].layerBytes(), nullptr, GL_STREAM_READ, "late cells") {}
    void start() override {
        outline_ = solver_.outline();
        std::size_t offset = 0;
        const auto copy = [&](const TexelTarget& from, int layers) {
            for (int layer = 0; layer < layers; ++layer, offset += from.layerBytes())
                from.copy(layer, cells_, offset);
        };
        copy(solver_.nodes_[solver_.currentNodes_], kNodeLayers);
        copy(solver_.bonds_[solver_.currentBonds_], kBondTexels);
        if (solver_.objects_) solver_.objects_->copy(objects_);
        done_ = gl::Fence::insert();
        glFlush();
    }
    State take() override {
        done_.wait();
        State state = outline_;
        std::vector<vec4> texels(cells_.size() / sizeof(vec4));
        cells_.read(0, cells_.size(), texels.data());
        const TexelTarget& nodes = solver_.nodes_[0];
        const auto at = [&](int layer) {
            return texels.data() + static_cast<std::size_t>(layer) * nodes.layerTexels();
        };
        solver_.readLayers(
            {0, solver_.world_.cellCount()}, state, [&](int layer) { return at(layer); },
            [&](int layer) { return at(kNodeLayers + layer); });
        if (solver_.objects_) solver_.objects_->read(objects_, state);
        return state;
    }

  private:
    static constexpr int kNodeLayers = 2 * kCorners, kLayers = kNodeLayers + kBondTexels;
    const GatherSolver& solver_;
    State outline_;
    gl::Buffer cells_, objects_;
    gl::Fence done_;
};

std::unique_ptr<StateCopy> GatherSolver::makeStateCopy() const {
    return std::make_unique<LateState>(*this);
}

void GatherSolver::push(const Event& event) {
    events_.schedule().add(event, step_);
    nextWake_ = std::min(nextWake_, event.nextStep(step_));
}

void GatherSolver::putObject(int object, const ObjectState& state) {
    wake(memberOfObject(world_, object));
    objects_->put(object, state, step_);
    wakeThreatened();
    bodiesChanged();
}

void GatherSolver::setState(const State& state) {
    step_ = state.step;
    events_.schedule().setAdded(state.pushes);
    if (incidents_) {
        incidents_->finish();
        incidents_->forget();
    }
    book_.follow(state);
    bookChanged();
    write({0, world_.cellCount()}, state);
    for (const int body : state.absent) writeBoth(cellsOf(world_, body), state);
    book_.wakeAll();
    showObjects(state);
    for (int body = 0; body < bodyCount(); ++body)
        if (holds(body)) changed(body);
    bodiesChanged();
    bindInputs();
    updateLinks();
}

void GatherSolver::archive(Archive& a) {
    a.section("step");
    const std::int64_t step = a.step(step_);
    events_.schedule().archive(a, step);
    const std::vector<bool> active = book_.archiveBodies(a);
    if (a.reads()) bookChanged();
    archiveCells(a);
    book_.archiveSleepers(a, active);
    monitor_.archive(a);
    archiveLooks(a);
    if (a.reads()) {
        step_ = step;
        follow();
    }
    if (contact_) contact_->archive(a);
    if (objects_) objects_->archive(a, [this](int object) { return book_.objectAsleep(object); });
    if (a.reads() && incidents_) {
        incidents_->finish();
        incidents_->forget();
        bonds_[currentBonds_].copy(0, incidents_->known());
    }
    IncidentPass::archive(a, world_, incidents_ ? &*incidents_ : nullptr);
}

/// Both halves of the ping-pong get the same: what sleeps is to be the same in both, and what is
/// awake is written before it is read.
void GatherSolver::archiveCells(Archive& a) {
    const TexelRange every{0, world_.cellCount()};
    const auto count = static_cast<std::size_t>(every.end);
    std::vector<vec4> first(count), second(count);
    std::vector<float> numbers(7 * count);
    const auto readBoth = [&](const TexelTarget& from, int layer) {
        if (!a.writes()) return;
        first = from.read(layer, every);
        second = from.read(layer + 1, every);
    };
    const auto writeBoth = [&](std::array<TexelTarget, 2>& to, int layer) {
        for (TexelTarget& half : to) {
            half.write(layer, 0, first);
            half.write(layer + 1, 0, second);
        }
    };
    a.section("nodes");
    for (int corner = 0; corner < kCorners; ++corner) {
        readBoth(nodes_[currentNodes_], 2 * corner);
        for (std::size_t i = 0; i < count; ++i) {
            float* to = &numbers[7 * i];
            for (int axis = 0; axis < 3; ++axis) to[axis] = first[i][axis];
            for (int k = 0; k < 4; ++k) to[3 + k] = second[i][k];
        }
        a.reals(std::span(numbers));
        if (!a.reads()) continue;
        for (std::size_t i = 0; i < count; ++i) {
            const float* from = &numbers[7 * i];
            const int node = kCorners * static_cast<int>(i) + corner;
            first[i] = {from[0], from[1], from[2],
                        static_cast<float>(world_.restPosition(node)[1])};
            second[i] = {from[3], from[4], from[5], from[6]};
        }
        writeBoth(nodes_, 2 * corner);
    }
    a.section("bonds");
    readBoth(bonds_[currentBonds_], 0);
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            float& damage = first[i][axis];
            if (isBond(world_, kBondsPerCell * static_cast<int>(i) + axis))
                damage = a.real(damage, 0.f, 1.f);
            else
                damage = static_cast<float>(kNoBond);
        }
        first[i].w = a.flag(first[i].w > 0) ? 1.f : 0.f;
        if (a.reads() && !present(world_.bodyOf(static_cast<int>(i)))) first[i].w = SUNDER_GONE;
        for (int k = 0; k < 4; ++k) second[i][k] = a.real(second[i][k]);
    }
    if (a.reads()) writeBoth(bonds_, 0);
}

void GatherSolver::archiveLooks(Archive& a) {
    a.section("looks");
    const bool newNodeWatch = a.flag(newNodeWatch_), newBondWatch = a.flag(newBondWatch_),
               stirred = a.flag(stirred_);
    const auto dropped = a.whole<std::int64_t>(droppedContacts_, 0, Archive::kLastStep);
    std::vector<double> haste = contactHaste_;
    a.list(haste, world_.bodies().size(), [&](double& x) { x = a.real(x, 0.); });
    if (!a.reads()) return;
    newNodeWatch_ = newNodeWatch;
    newBondWatch_ = newBondWatch;
    stirred_ = stirred;
    droppedContacts_ = dropped;
    contactHaste_ = std::move(haste);
}

void GatherSolver::setPresent(int body, bool present) {
    if (book_.present(body) == present) return;
    if (book_.active(body)) {
        std::vector<RestBox> own;
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            if (chunk.box.member == memberOfBody(body)) own.push_back(chunk.box);
        wakeAround(body, own);
    }
    book_.setPresent(body, present);
    bookChanged();
    const TexelRange cells = cellsOf(world_, body);
    writeBoth(cells, world_.initialState());
    if (!holds(body)) return;
    changed(body);
    if (present) {
        const Box box = world_.bodies()[body].bounds();
        const Vec3 reach = Vec3::Constant(restReach(world_.bodies()[body]));
        wakeAround(body, {{memberOfBody(body), box.low - reach, box.high + reach}});
    }
    bodiesChanged();
    relink(body);
}

void GatherSolver::releaseAnchors(int body) {
    if (!book_.releaseAnchors(body)) return;
    bookChanged();
    if (!holds(body)) return;
    // Contacts are searched for anew only where something wakes, for others' bits.
    if (asleep(body)) {
        wake(memberOfBody(body));
        bodiesChanged();
    }
    changed(body);
    relink(body);
}

void GatherSolver::relink(int body) {
    const TexelRange cells = cellsOf(world_, body);
    TexelRanges own(1, "a body's cells");
    own.set({&cells, 1}, columns_);
    bindInputs();
    links_.fill(linkProgram_, own);
}

void GatherSolver::wakeAround(int body, const std::vector<RestBox>& own) {
    const auto addBoxes = [&](std::vector<RestBox>& boxes) {
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            if (asleep(chunk.box.member)) boxes.push_back(chunk.box);
    };
    woke(book_.wakeAround(body, own, addBoxes, knownObjects()));
}

const std::vector<ObjectState>& GatherSolver::knownObjects() const {
    static const std::vector<ObjectState> kNone;
    return objects_ ? objects_->known() : kNone;
}

void GatherSolver::bookChanged() {
    for (int body = 0; body < bodyCount(); ++body)
        monitor_.setBody(body, present(body), book_.released(body));
    released_.write(book_);
}

void GatherSolver::writeBoth(TexelRange cells, const State& state) {
    for (int half = 0; half < 2; ++half) {
        write(cells, state);
        currentNodes_ = 1 - currentNodes_;
        currentBonds_ = 1 - currentBonds_;
    }
}

void GatherSolver::follow() {
    bodiesChanged();
    bindInputs();
    const TexelRange every{0, world_.cellCount()};
    TexelRanges cells(1, "all cells");
    cells.set({&every, 1}, columns_);
    links_.fill(linkProgram_, cells);
}

void GatherSolver::adopt(const std::vector<int>& bodies, const State& state) {
    std::vector<int> there;
    for (const int body : bodies)
        if (present(body)) there.push_back(body);
    const std::vector<TexelRange> cells = rangesOf(world_, there);
    for (const TexelRange& range : cells) write(range, state);
    if (objects_) {
        State now;
        objects_->read(now);
        for (int object = 0; object < objectCount(); ++object) {
            if (now.objects[object] == state.objects[object]) continue;
            wake(memberOfObject(world_, object));
            objects_->put(object, state.objects[object], step_);
        }
    }
    for (const int body : bodies) {
        wake(memberOfBody(body));
        book_.setHeld(body, true);
        changed(body);
    }
    bodiesChanged();
    if (cells.empty()) return;
    TexelRanges adopted(cells.size(), "adopted cells");
    adopted.set(cells, columns_);
    bindInputs();
    links_.fill(linkProgram_, adopted);
}

void GatherSolver::release(const std::vector<int>& bodies, State& state) {
    for (const TexelRange& range : rangesOf(world_, bodies)) read(range, state);
    if (objects_) objects_->read(state);
    for (const int body : bodies) {
        wake(memberOfBody(body));
        book_.setHeld(body, false);
    }
    bodiesChanged();
}

void GatherSolver::show(int body, const State& state) {
    write(cellsOf(world_, body), state);
}

void GatherSolver::showObjects(const State& state) {
    if (objects_) objects_->set(state);
}

void GatherSolver::write(TexelRange cells, const State& state) {
    std::vector<vec4> u(static_cast<std::size_t>(cells.end - cells.first)), v = u, damage = u,
                                                                            slow = u;
    for (int corner = 0; corner < kCorners; ++corner) {
        for (std::size_t i = 0; i < u.size(); ++i) {
            const int node = kCorners * (cells.first + static_cast<int>(i)) + corner;
            u[i] = toVec4(state.displacement[node], world_.restPosition(node)[1]);
            v[i] = toVec4(state.velocity[node], 0);
        }
        nodes_[currentNodes_].write(2 * corner, cells.first, u);
        nodes_[currentNodes_].write(2 * corner + 1, cells.first, v);
    }
    for (std::size_t i = 0; i < damage.size(); ++i) {
        const bool there = present(world_.bodyOf(cells.first + static_cast<int>(i)));
        damage[i].w = there ? 0.f : static_cast<float>(SUNDER_GONE);
        slow[i].w = static_cast<float>(state.slowStress[cells.first + static_cast<int>(i)]);
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            const int bond = kBondsPerCell * (cells.first + static_cast<int>(i)) + axis;
            damage[i][axis] = static_cast<float>(state.damage[bond]);
            slow[i][axis] = static_cast<float>(state.slow[bond]);
        }
    }
    bonds_[currentBonds_].write(0, cells.first, damage);
    bonds_[currentBonds_].write(1, cells.first, slow);
    if (incidents_)
        incidents_->known().write(cells.first * sizeof(vec4), damage.size() * sizeof(vec4),
                                  damage.data());
}

template <class NodeLayer, class BondLayer>
void GatherSolver::readLayers(TexelRange cells, State& state, const NodeLayer& nodes,
                              const BondLayer& bonds) const {
    const int count = cells.end - cells.first;
    for (int corner = 0; corner < kCorners; ++corner) {
        const auto u = nodes(2 * corner), v = nodes(2 * corner + 1);
        for (int i = 0; i < count; ++i) {
            const int node = kCorners * (cells.first + i) + corner;
            state.displacement[node] = {u[i].x, u[i].y, u[i].z};
            state.velocity[node] = {v[i].x, v[i].y, v[i].z};
        }
    }
    const auto damage = bonds(0), slow = bonds(1);
    for (int i = 0; i < count; ++i) {
        state.slowStress[cells.first + i] = slow[i].w;
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            const int bond = kBondsPerCell * (cells.first + i) + axis;
            state.damage[bond] = damage[i][axis];
            state.slow[bond] = slow[i][axis];
        }
    }
}

void GatherSolver::read(TexelRange cells, State& state) const {
    readLayers(
        cells, state, [&](int layer) { return nodes_[currentNodes_].read(layer, cells); },
        [&](int layer) { return bonds_[currentBonds_].read(layer, cells); });
}

void GatherSolver::Copy::update(const TexelTarget& from, std::initializer_list<int> layers,
                                const char* what) {
    if (buffer.size() == 0) {
        buffer = gl::Buffer(layers.size() * from.layerBytes(), nullptr, GL_STREAM_COPY, what);
        texture = gl::makeBufferTexture(buffer, GL_RGBA32F, what);
    }
    std::size_t offset = 0;
    for (const int layer : layers) {
        from.copy(layer, buffer, offset);
        offset += from.layerBytes();
    }
}

StateView GatherSolver::view() {
    drawnNodes_.update(nodes_[currentNodes_], {0, 2, 4, 6, 8, 10, 12, 14}, "drawn nodes");
    drawnDamage_.update(bonds_[currentBonds_], {0}, "drawn bonds");
    return {&drawnNodes_.texture,  1, static_cast<int>(nodes_[0].layerTexels()),
            &drawnDamage_.texture, 1, objects_ ? &objects_->places() : nullptr};
}

void GatherSolver::finish() {
    glFinish();
    if (incidents_) incidents_->finish();
}

void GatherSolver::setIncidents(IncidentRing* ring) {
    incidents_.reset();
    if (!ring) return;
    incidents_.emplace(world_, ContactPass::Storage::Textures, columns_,
                       contact_ ? &*contact_ : nullptr, objects_ ? &*objects_ : nullptr, *ring);
    bonds_[currentBonds_].copy(0, incidents_->known());
}

void GatherSolver::bindInputs() const {
    bindWorld(buffers_);
    released_.bind();
    gl::bindTexture(kEvents, GL_TEXTURE_BUFFER, events_.texture());
    gl::bindTexture(kLinks, GL_TEXTURE_2D_ARRAY, links_.texture());
    gl::bindTexture(kForces, GL_TEXTURE_2D_ARRAY, forces_.texture());
    gl::bindTexture(kNodes, GL_TEXTURE_2D_ARRAY, nodes_[currentNodes_].texture());
    gl::bindTexture(kBonds, GL_TEXTURE_2D_ARRAY, bonds_[currentBonds_].texture());
}

void GatherSolver::advance(int steps) {
    const bool events = events_.write(step_, steps);
    bindInputs();
    for (int i = 0; i < steps; ++i) {
        advanceOne(events, i);
        ++step_;
        if (incidents_ && incidents_->due(step_)) lookForIncidents();
    }
    // The GPU begins at once, not when the queue is full: the CPU may have work of its own.
    glFlush();
}

void GatherSolver::advanceOne(bool events, int stepInFrame) {
    if (step_ >= nextWake_) wakePushed();
    if (objects_) startThrows();
    if (!moving()) return;
    stirred_ = true;
    if (step_ % monitor_.interval() == 0) watch();
    {
        const TimedPass timed(passTimer_, "elements");
        forces_.fill(forceProgram_, awake_);
    }
    observe(passObserver_, "elements", forces_, world_.cellCount(), kCorners);
    if (contact_) addContacts();
    if (objects_) addObjects(events, stepInFrame);
    if (incidents_ && contact_) incidents_->addPushes();
    // Stresses are those before the nodes move; what they break shows in the links of the next
    // step.
    const bool fracture = breakable_ && step_ % world_.description().fractureInterval == 0;
    if (fracture) updateBonds();
    updateNodes(events, stepInFrame);
    if (objects_) objects_->move();
    if (fracture) updateLinks();
}

void GatherSolver::lookForIncidents() {
    if (!std::exchange(stirred_, false)) {
        incidents_->finish();
        return;
    }
    const TimedPass timed(passTimer_, "incidents");
    incidents_->look(step_);
    bonds_[currentBonds_].copy(0, incidents_->known());
}

void GatherSolver::addContacts() {
    contact_->update(step_, passTimer_);
    const TimedPass timed(passTimer_, "contacts");
    contact_->push(forces_);
    observe(passObserver_, "contacts", forces_, world_.cellCount(), kCorners);
}

void GatherSolver::addObjects(bool events, int stepInFrame) {
    const TimedPass timed(passTimer_, "objects");
    if (events && events_.schedule().nextBlast(step_) == step_) objects_->accelerate(stepInFrame);
    objects_->push(step_);
    forces_.bind();
    objects_->drawForces();
    observe(passObserver_, "objects", forces_, world_.cellCount(), kCorners);
}

bool GatherSolver::moving() const {
    return awake_.rectangles() > 0 || (objects_ && book_.holdsAny() && objects_->anyAwake());
}

/// Stresses live for one pass: in the node textures that this step is about to fill.
void GatherSolver::updateBonds() {
    const TexelTarget& scratch = nodes_[1 - currentNodes_];
    {
        const TimedPass timed(passTimer_, "stresses");
        scratch.fill(stressProgram_, awake_);
        gl::bindTexture(kStresses, GL_TEXTURE_2D_ARRAY, scratch.texture());
    }
    observe(passObserver_, "stresses", scratch, world_.cellCount(), stressLayers(world_));
    const TimedPass timed(passTimer_, "bonds");
    bondProgram_.use();
    glUniform1i(bondWatchUniform_, std::exchange(newBondWatch_, false));
    currentBonds_ = 1 - currentBonds_;
    bonds_[currentBonds_].fill(bondProgram_, awake_);
    gl::bindTexture(kBonds, GL_TEXTURE_2D_ARRAY, bonds_[currentBonds_].texture());
}

void GatherSolver::updateLinks() {
    const TimedPass timed(passTimer_, "links");
    links_.fill(linkProgram_, awake_);
    observe(passObserver_, "links", links_, world_.cellCount(), SUNDER_LINK_TEXELS);
}

void GatherSolver::updateNodes(bool events, int stepInFrame) {
    const TimedPass timed(passTimer_, "nodes");
    const NodePass& pass = events ? pushedNodes_ : plainNodes_;
    currentNodes_ = 1 - currentNodes_;
    for (int part = 0; part < kNodeParts; ++part) {
        pass.programs[part].use();
        glUniform1i(pass.newWatch[part], newNodeWatch_);
        if (events) glUniform1f(pass.stepInFrame[part], static_cast<float>(stepInFrame));
        nodes_[currentNodes_].fill(pass.programs[part], awake_, part);
    }
    newNodeWatch_ = false;
    gl::bindTexture(kNodes, GL_TEXTURE_2D_ARRAY, nodes_[currentNodes_].texture());
}

/// Looks for bodies and objects that have come to rest, and for sleepers that something hits.
void GatherSolver::watch() {
    RestMonitor::News news;
    {
        const TimedPass timed(passTimer_, "rest");
        if (contact_) {
            gl::bindTexture(kSummaries, GL_TEXTURE_2D_ARRAY, contact_->summaries());
            gl::bindTexture(kHastes, GL_TEXTURE_2D_ARRAY, contact_->hastes());
        }
        news = monitor_.look(step_);
        if (contact_) contact_->forgetHaste();
    }
    newNodeWatch_ = newBondWatch_ = true;
    droppedContacts_ = std::max(droppedContacts_, news.dropped);
    raiseHaste(contactHaste_, news.haste);
    if (objects_) objects_->look(step_, monitor_.interval());
    rest();
    for (const int body : news.hit) wake(memberOfBody(body));
    if (objects_) wakeThreatened();
    if (!news.hit.empty()) bodiesChanged();
}

void GatherSolver::rest() {
    const std::int64_t before = step_ - monitor_.interval();
    if (events_.schedule().nextBlast(before) <= step_)
        for (int object = 0; object < objectCount(); ++object)
            if (blastedWithin(object, before, step_ + 1)) objects_->disturb(object, step_);
    const auto addBoxes = [&](std::vector<RestBox>& boxes) {
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            if (book_.active(chunk.box.member)) boxes.push_back(chunk.box);
    };
    const auto [bodies, objects] =
        book_.settle([this](int body) { return monitor_.ready(body); }, addBoxes,
                     [this](int object) { return objects_->restStatus(object); }, knownObjects());
    if (!objects.empty()) objects_->setAsleep(objects, true, step_);
    if (!bodies.empty()) fallAsleep(bodies);
}

void GatherSolver::woke(const BodyBook::Members& members) {
    if (!members.objects.empty()) objects_->setAsleep(members.objects, false, step_);
    for (const int body : members.bodies) changed(body);
}

void GatherSolver::changed(int body) {
    monitor_.disturb(body, step_);
}

/// Their velocities become zero, and both halves of the ping-pong the same: the passes no longer
/// touch them.
void GatherSolver::fallAsleep(const std::vector<int>& calm) {
    TexelRanges falling(calm.size(), "calm cells");
    falling.set(rangesOf(world_, calm), columns_);
    const auto copy = [&](const gl::Program& program, const TexelTarget& from,
                          const TexelTarget& to, int part) {
        gl::bindTexture(kRecords, GL_TEXTURE_2D_ARRAY, from.texture());
        to.fill(program, falling, part);
    };
    const TexelTarget &nodes = nodes_[currentNodes_], &otherNodes = nodes_[1 - currentNodes_];
    for (int part = 0; part < kNodeParts; ++part) {
        copy(stillNodePrograms_[part], nodes, otherNodes, part);
        copy(stillNodePrograms_[part], otherNodes, nodes, part);
    }
    copy(stillBondProgram_, bonds_[currentBonds_], bonds_[1 - currentBonds_], 0);
    bodiesChanged();
}

void GatherSolver::startThrows() {
    for (const Throw& thrown : world_.throws())
        if (thrown.step == step_) putObject(thrown.object, thrown.state);
}

void GatherSolver::wakePushed() {
    const EventSchedule& events = events_.schedule();
    std::vector<bool> pushed(world_.bodies().size());
    bool blasted = false, begins = false;
    for (const int index : events.blasts()) {
        const Event& blast = events.all()[index];
        if (blast.nextStep(step_) > step_) continue;
        blasted = true;
        begins |= blast.nextStep(step_ - 1) == step_;
        // Without contact nobody knows where they are.
        if (!contact_) pushed.assign(pushed.size(), true);
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            if (const auto body = static_cast<std::size_t>(chunk.box.member);
                body < pushed.size() && blast.reaches(chunk.box.low, chunk.box.high))
                pushed[body] = true;
    }
    bool any = false;
    for (int body = 0; body < bodyCount(); ++body) {
        if (!asleep(body) || !(pushed[body] || events.pushedWithin(body, step_, step_ + 1)))
            continue;
        wake(memberOfBody(body));
        any = true;
    }
    for (int object = 0; blasted && object < objectCount(); ++object) {
        if (!objectAsleep(object) || !blastedWithin(object, step_, step_ + 1)) continue;
        wake(memberOfObject(world_, object));
        any = true;
    }
    if (any) bodiesChanged();
    if (objects_ && begins) wakeThreatened();
    findNextWake(step_ + 1);
}

bool GatherSolver::blastedWithin(int object, std::int64_t from, std::int64_t to) const {
    if (objects_->restStatus(object) == RestIslands::Status::Apart) return false;
    const RestBox box = restBoxOf(world_, object, knownObjects()[object]);
    return events_.schedule().blastWithin(from, to, box.low, box.high);
}

void GatherSolver::findNextWake(std::int64_t from) {
    nextWake_ = std::numeric_limits<std::int64_t>::max();
    const EventSchedule& events = events_.schedule();
    bool anyAsleep = false;
    for (int body = 0; body < bodyCount(); ++body) {
        if (!asleep(body)) continue;
        anyAsleep = true;
        nextWake_ = std::min(nextWake_, events.nextPush(body, from));
    }
    for (int object = 0; object < objectCount(); ++object) anyAsleep |= objectAsleep(object);
    if (anyAsleep) nextWake_ = std::min(nextWake_, events.nextBlast(from));
}

/// What sleeps where something that moves may come before the next look.
void GatherSolver::wakeThreatened() {
    objects_->expect(events_.schedule(), step_);
    bool any = false;
    for (int body = 0; body < bodyCount(); ++body) {
        if (!asleep(body) || !objects_->threatens(body)) continue;
        wake(memberOfBody(body));
        any = true;
    }
    for (int object = 0; object < objectCount(); ++object) {
        if (!objects_->asleep(object)) continue;
        bool threatened = objects_->threatensObject(object);
        for (const RestMonitor::Chunk& chunk : monitor_.chunks())
            threatened |= book_.awake(chunk.box.member) &&
                          objects_->threatenedBy(object, chunk.box, chunk.fastest);
        if (!threatened) continue;
        wake(memberOfObject(world_, object));
        any = true;
    }
    if (any) bodiesChanged();
}

void GatherSolver::bodiesChanged() {
    const std::vector<TexelRange> awake = rangesOf(world_, book_.awakeBodies()),
                                  active = rangesOf(world_, book_.activeBodies());
    awake_.set(awake, columns_);
    if (contact_) contact_->setCells(awake, active);
    if (objects_) objects_->setCells(active);
    findNextWake(step_);
}

}  // namespace sunder::gpu
