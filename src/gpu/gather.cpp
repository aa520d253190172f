#include "gpu/gather.hpp"

#include <algorithm>
#include <utility>

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

GatherSolver::GatherSolver(const World& world, const WorldBuffers& buffers, Stage stage)
    : world_(world),
      buffers_(buffers),
      stage_((stage == Stage::Compute ? requireCompute() : void(), stage)),
      breakable_(world.breakable()),
      columns_(texelColumns(world.cellCount())),
      events_(world),
      nodes_{TexelTarget(world.cellCount(), columns_, 2 * kCorners, "nodes"),
             TexelTarget(world.cellCount(), columns_, 2 * kCorners, "nodes")},
      bonds_{TexelTarget(world.cellCount(), columns_, 2, "bonds"),
             TexelTarget(world.cellCount(), columns_, 2, "bonds")},
      forces_(world.cellCount(), columns_, kCorners, "forces"),
      forcePass_(stage, forces_, world, "gather/element.frag", {{"STRESSES", "0"}}),
      plainNodes_(nodePass("0")),
      pushedNodes_(nodePass("1")),
      stillBondProgram_(bonds_[0].program(world, "gather/still.frag", {{"NODES", "0"}})),
      stillNodePrograms_{
          nodes_[0].program(world, "gather/still.frag", {{"NODES", "1"}, {"FIRST", "0"}}),
          nodes_[0].program(world, "gather/still.frag", {{"NODES", "1"}, {"FIRST", "4"}})},
      book_(world),
      released_(world),
      awake_(stage, world.bodies().size(), "awake cells"),
      monitor_(world, columns_, events_.schedule()) {
    if (stage == Stage::Compute)
        if (std::optional<BlockPlan> plan = BlockPass::planFor(world))
            blocks_.emplace(world, std::move(*plan), columns_);
    for (int half = 0; half < (blocks_ ? 2 : 1); ++half)
        links_.emplace_back(world.cellCount(), columns_, SUNDER_LINK_TEXELS, "links");
    linkPass_ = CellPass(stage, links_[0], world, "gather/links.frag");
    if (breakable_) {
        const gl::Defines defines = breakDefines(world);
        stressPass_ = CellPass(stage, nodes_[0], world, "gather/element.frag",
                               gl::with(defines, "STRESSES", "1"));
        bondPass_ = CellPass(stage, bonds_[0], world, "gather/fracture.frag", defines);
        bondWatchUniform_ = bondPass_.program().uniform("newWatch");
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
    for (int part = 0; part < nodeParts(); ++part) {
        pass.parts[part] = CellPass(stage_, nodes_[0], world_, "gather/node.frag",
                                    {{"EVENTS", events},
                                     {"ROOM", world_.description().room ? "1" : "0"},
                                     {"FIRST", first[part]}},
                                    kCorners);
        const gl::Program& program = pass.parts[part].program();
        pass.newWatch[part] = program.uniform("newWatch");
        pass.stepInFrame[part] = program.uniform("stepInFrame");
    }
    return pass;
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
    gl::bindTexture(kForces, GL_TEXTURE_2D_ARRAY, forces_.texture());
    bindState();
}

void GatherSolver::bindState() const {
    gl::bindTexture(kNodes, GL_TEXTURE_2D_ARRAY, nodes_[currentNodes_].texture());
    gl::bindTexture(kBonds, GL_TEXTURE_2D_ARRAY, bonds_[currentBonds_].texture());
    gl::bindTexture(kLinks, GL_TEXTURE_2D_ARRAY, links_[currentLinks_].texture());
}

void GatherSolver::advance(int steps) {
    const bool events = events_.write(step_, steps);
    bindInputs();
    for (int done = 0; done < steps;) {
        const int some = advanceSome(events, done, steps - done);
        done += some;
        step_ += some;
        if (incidents_ && incidents_->due(step_)) lookForIncidents();
    }
    // The GPU begins at once, not when the queue is full: the CPU may have work of its own.
    glFlush();
}

int GatherSolver::advanceSome(bool events, int stepInFrame, int most) {
    if (step_ >= nextWake_) wakePushed();
    if (objects_) startThrows();
    if (!moving()) return 1;
    stirred_ = true;
    if (step_ % monitor_.interval() == 0) watch();
    if (blocks_) return advanceBlocks(events, stepInFrame, passObserver_ ? 1 : most);
    advanceOne(events, stepInFrame);
    return 1;
}

int GatherSolver::advanceBlocks(bool events, int stepInFrame, int most) {
    const auto until = [&](std::int64_t step) {
        most = static_cast<int>(std::min<std::int64_t>(most, step - step_));
    };
    until(nextWake_);
    until((step_ / monitor_.interval() + 1) * monitor_.interval());
    if (incidents_) until(incidents_->next(step_));
    const BlockPass::Span span{.step = step_,
                               .substeps = blocks_->substepsFrom(step_, most),
                               .pushed = events,
                               .stepInFrame = stepInFrame,
                               .newNodeWatch = newNodeWatch_,
                               .newBondWatch = newBondWatch_};
    const TimedPass timed(passTimer_, "blocks");
    currentNodes_ = 1 - currentNodes_;
    const bool looks = blocks_->looks(span);
    if (looks) {
        currentBonds_ = 1 - currentBonds_;
        currentLinks_ = 1 - currentLinks_;
        newBondWatch_ = false;
    }
    newNodeWatch_ = false;
    blocks_->run(span, nodes_[currentNodes_], bonds_[currentBonds_], links_[currentLinks_]);
    bindState();
    observe(passObserver_, "blocks", nodes_[currentNodes_], world_.cellCount(), 2 * kCorners);
    if (looks)
        observe(passObserver_, "links", links_[currentLinks_], world_.cellCount(),
                SUNDER_LINK_TEXELS);
    return span.substeps;
}

void GatherSolver::advanceOne(bool events, int stepInFrame) {
    {
        const TimedPass timed(passTimer_, "elements");
        forcePass_.run(forces_, awake_);
    }
    observe(passObserver_, "elements", forces_, world_.cellCount(), kCorners);
    if (contact_) addContacts();
    if (objects_) addObjects(events, stepInFrame);
    if (incidents_ && contact_) incidents_->addPushes();
    // Stresses are those before the nodes move; what they break shows in the links of the next
    // step.
    const bool fracture = breakable_ && step_ % world_.fractureInterval() == 0;
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
    return !awake_.empty() || (objects_ && book_.holdsAny() && objects_->anyAwake());
}

/// Stresses live for one pass: in the node textures that this step is about to fill.
void GatherSolver::updateBonds() {
    const TexelTarget& scratch = nodes_[1 - currentNodes_];
    {
        const TimedPass timed(passTimer_, "stresses");
        stressPass_.run(scratch, awake_);
        gl::bindTexture(kStresses, GL_TEXTURE_2D_ARRAY, scratch.texture());
    }
    observe(passObserver_, "stresses", scratch, world_.cellCount(), stressLayers(world_));
    const TimedPass timed(passTimer_, "bonds");
    bondPass_.program().use();
    glUniform1i(bondWatchUniform_, std::exchange(newBondWatch_, false));
    currentBonds_ = 1 - currentBonds_;
    bondPass_.run(bonds_[currentBonds_], awake_);
    gl::bindTexture(kBonds, GL_TEXTURE_2D_ARRAY, bonds_[currentBonds_].texture());
}

void GatherSolver::updateLinks() {
    const TimedPass timed(passTimer_, "links");
    linkPass_.run(links_[currentLinks_], awake_);
    observe(passObserver_, "links", links_[currentLinks_], world_.cellCount(), SUNDER_LINK_TEXELS);
}

void GatherSolver::writeLinks(const CellSet& cells) {
    for (const TexelTarget& links : links_) linkPass_.run(links, cells);
}

void GatherSolver::updateNodes(bool events, int stepInFrame) {
    const TimedPass timed(passTimer_, "nodes");
    const NodePass& pass = events ? pushedNodes_ : plainNodes_;
    currentNodes_ = 1 - currentNodes_;
    for (int part = 0; part < nodeParts(); ++part) {
        pass.parts[part].program().use();
        glUniform1i(pass.newWatch[part], newNodeWatch_);
        if (events) glUniform1f(pass.stepInFrame[part], static_cast<float>(stepInFrame));
        pass.parts[part].run(nodes_[currentNodes_], awake_, part);
    }
    newNodeWatch_ = false;
    gl::bindTexture(kNodes, GL_TEXTURE_2D_ARRAY, nodes_[currentNodes_].texture());
}

void GatherSolver::startThrows() {
    for (const Throw& thrown : world_.throws())
        if (thrown.step == step_) putObject(thrown.object, thrown.state);
}

}  // namespace sunder::gpu
