#include "gpu/scatter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/archive.hpp"
#include "core/tetrahedra.hpp"
#include "gl/vertex_array.hpp"
#include "gpu/body_ranges.hpp"
#include "gpu/layout.hpp"
#include "gpu/observed_pass.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

/// The finite element structure of the thesis, chapter 6.
struct ElementVertex {
    std::int32_t nodes[4];
    glm::mat3 inverseRest;
};

void drawBuffers(int count) {
    constexpr GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(count, both);
}

/// Texels of a float texture with room for every node and every tetrahedron's stress.
std::int64_t texelCount(const World& world) {
    return std::int64_t{std::max(kCorners, SUNDER_STRESS_TEXELS * kTetrahedraPerCell)} *
           world.cellCount();
}

}  // namespace

ScatterSolver::ScatterSolver(const World& world, const WorldBuffers& buffers)
    : world_(world),
      buffers_(buffers),
      book_(world),
      released_(world),
      width_(texelColumns(texelCount(world))),
      height_(texelRows(texelCount(world), width_, "forces and stresses")),
      breakable_(world.breakable()),
      bonds_(world, width_),
      events_(world),
      nodes_{{{NodeBuffer(world), {}}, {NodeBuffer(world), {}}}},
      noAttributes_(gl::makeVertexArray()) {
    for (NodeSide& side : nodes_)
        side.attributes =
            gl::makeVertexArray({{side.nodes.buffer(),
                                  sizeof(NodeRecord),
                                  {{0, 4, GL_FLOAT, offsetof(NodeRecord, displacement)},
                                   {1, 4, GL_FLOAT, offsetof(NodeRecord, velocity)}}}});
    makeElementBuffer();
    makeTargets();
    if (world.description().contact) {
        contact_.emplace(world, width_, ContactPass::Storage::Buffers);
        const TexelRange all{0, world.cellCount()};
        contact_->setCells({&all, 1}, {&all, 1});
        if (!world.objects().empty()) {
            objects_.emplace(world, buffers, ContactPass::Storage::Buffers, width_, height_);
            objects_->setCells({&all, 1});
        }
    }
    makePrograms();
    setState(world.initialState());
}

void ScatterSolver::makeElementBuffer() {
    std::vector<ElementVertex> elements;
    elements.reserve(std::size_t{kTetrahedraPerCell} * world_.cellCount());
    for (int cell = 0; cell < world_.cellCount(); ++cell)
        for (const Tetrahedron& tet : kTetrahedra[world_.parity(cell)]) {
            ElementVertex& element = elements.emplace_back();
            Mat3 rest;
            for (int i = 0; i < 3; ++i)
                rest.col(i) =
                    world_.cornerOffset(cell, tet[i + 1]) - world_.cornerOffset(cell, tet[0]);
            const Mat3 inverse = rest.inverse();
            for (int i = 0; i < 4; ++i) element.nodes[i] = kCorners * cell + tet[i];
            for (int column = 0; column < 3; ++column)
                for (int row = 0; row < 3; ++row)
                    element.inverseRest[column][row] = static_cast<float>(inverse(row, column));
        }
    elementBuffer_ = gl::makeBuffer<ElementVertex>(elements, GL_STATIC_DRAW, "finite elements");
    gl::VertexInput input{
        elementBuffer_, sizeof(ElementVertex), {{0, 4, GL_INT, offsetof(ElementVertex, nodes)}}};
    for (GLuint column = 0; column < 3; ++column)
        input.attributes.push_back(
            {1 + column, 3, GL_FLOAT,
             offsetof(ElementVertex, inverseRest) + column * sizeof(glm::vec3)});
    elementAttributes_ = gl::makeVertexArray({input});
}

void ScatterSolver::makeTargets() {
    forceTexture_ = gl::makeTexture2D(width_, height_, GL_RGBA32F, "force texture");
    stressTexture_ = gl::makeTexture2D(width_, height_, GL_RGBA32F, "stress texture");
    cumulativeTexture_ = gl::makeTexture2D(width_, height_, GL_RGBA32F, "cumulative force texture");
    elementTarget_ = makeTarget({&forceTexture_, &stressTexture_});
    cumulativeTarget_ = makeTarget({&cumulativeTexture_});
    writeInverseMasses();
}

void ScatterSolver::writeInverseMasses() {
    // The force texture's alpha carries the inverse mass of each node's copy and is masked from
    // here on; 0 anchors the node.
    std::vector<vec4> texels(static_cast<std::size_t>(width_) * height_, vec4(0));
    for (int node = 0; node < world_.nodeCount(); ++node)
        if (const int body = world_.bodyOf(node / kCorners);
            (!world_.anchored(node) || book_.released(body)) && world_.nodeMass(node) > 0 &&
            present(body))
            texels[node].w = static_cast<float>(1 / world_.nodeMass(node));
    gl::bindForWork(GL_TEXTURE_2D, forceTexture_);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_FLOAT, texels.data());
}

void ScatterSolver::makePrograms() {
    for (const int fracture : {0, 1})
        elementPrograms_[fracture] = gl::Program(
            {.vertex = "scatter/element.vert",
             .geometry = "scatter/element.geom",
             .fragment = "scatter/element.frag",
             .defines = withTurned({{"FRACTURE", std::to_string(fracture)}}, world_.anyTurned()),
             .attributes = {{"nodeIndices", 0}, {"inverseRest", 1}}});
    connectivityProgram_ = gl::Program(
        {.vertex = "scatter/connectivity.vert", .fragment = "scatter/connectivity.frag"});
    nodeProgram_ = gl::Program({.vertex = "scatter/node.vert",
                                .defines = {{"ROOM", world_.description().room ? "1" : "0"}},
                                .feedback = {"newDisplacement", "newVelocity"},
                                .attributes = {{"displacement", 0}, {"velocity", 1}}});
    if (contact_)
        contactProgram_ = gl::Program({.vertex = "scatter/contact.vert",
                                       .geometry = "scatter/contact.geom",
                                       .fragment = "scatter/element.frag",
                                       .defines = gl::with(contact_->defines(), "FRACTURE", "0")});
    for (const gl::Program* program : {&elementPrograms_[0], &elementPrograms_[1], &contactProgram_,
                                       &connectivityProgram_, &nodeProgram_}) {
        if (!*program) continue;
        setConstants(*program, world_, width_);
        glUniform1f(program->uniform("targetHeight"), static_cast<float>(height_));
    }
    stepInFrameUniform_ = nodeProgram_.uniform("stepInFrame");
}

State ScatterSolver::outline() const {
    State state;
    state.step = step_;
    state.pushes = events_.schedule().added(step_);
    book_.describe(state);
    return state;
}

class ScatterSolver::LateState : public StateCopy {
  public:
    explicit LateState(const ScatterSolver& solver)
        : solver_(solver), nodes_(solver.world_), bonds_(solver.world_) {}
    void start() override {
        outline_ = solver_.outline();
        nodes_.copy(solver_.nodes_[solver_.currentNodes_].nodes);
        bonds_.copy(solver_.bonds_.bonds());
        if (solver_.objects_) solver_.objects_->copy(objects_);
        done_ = gl::Fence::insert();
        glFlush();
    }
    State take() override {
        done_.wait();
        State state = outline_;
        nodes_.read(state);
        bonds_.read(state);
        if (solver_.objects_) solver_.objects_->read(objects_, state);
        return state;
    }

  private:
    const ScatterSolver& solver_;
    State outline_;
    NodeBuffer nodes_;
    BondBuffer bonds_;
    gl::Buffer objects_;
    gl::Fence done_;
};

std::unique_ptr<StateCopy> ScatterSolver::makeStateCopy() const {
    return std::make_unique<LateState>(*this);
}

State ScatterSolver::state() const {
    State state = outline();
    nodes_[currentNodes_].nodes.read(state);
    bonds_.bonds().read(state);
    if (objects_) objects_->read(state);
    return state;
}

void ScatterSolver::setState(const State& state) {
    step_ = state.step;
    events_.schedule().setAdded(state.pushes);
    follow(state);
    nodes_[currentNodes_].nodes.write(state);
    bindBodies();
    bonds_.write(state, feedback_);
    if (contact_) contact_->forget();
    if (objects_) objects_->set(state);
    if (!incidents_) return;
    incidents_->finish();
    incidents_->forget();
    incidents_->known().copy(bonds_.bonds().buffer());
}

void ScatterSolver::setPresent(int body, bool present) {
    if (book_.present(body) == present) return;
    State now = state();
    world_.setPresent(now, body, present);
    follow(now);
    nodes_[currentNodes_].nodes.write(now);
    bindBodies();
    bonds_.write(now, feedback_);
    if (incidents_) incidents_->known().copy(bonds_.bonds().buffer());
}

void ScatterSolver::releaseAnchors(int body) {
    if (!book_.releaseAnchors(body)) return;
    released_.write(book_);
    writeInverseMasses();
    bindBodies();
    bonds_.updateLinks(feedback_);
}

void ScatterSolver::follow(const State& state) {
    if (state.absent == book_.absent() && state.released == book_.released()) return;
    book_.follow(state);
    released_.write(book_);
    writeInverseMasses();
    const std::vector<TexelRange> there = rangesOf(world_, book_.activeBodies());
    if (contact_) contact_->setCells(there, there);
    if (objects_) objects_->setCells(there);
}

void ScatterSolver::bindBodies() const {
    bindWorld(buffers_);
    released_.bind();
}

void ScatterSolver::archive(Archive& a) {
    a.section("step");
    const std::int64_t step = a.step(step_);
    events_.schedule().archive(a, step);
    State now = a.writes() ? state() : world_.initialState();
    archiveBodies(a, world_, now.absent, now.released);
    archiveCells<float>(a, world_, now);
    a.section("looks");
    const auto dropped = a.whole<std::int64_t>(droppedContacts_, 0, Archive::kLastStep);
    std::vector<double> haste = contactHaste_;
    a.list(haste, world_.bodies().size(), [&](double& x) { x = a.real(x, 0.); });
    if (a.reads()) {
        step_ = step;
        droppedContacts_ = dropped;
        contactHaste_ = std::move(haste);
        follow(now);
        nodes_[currentNodes_].nodes.write(now);
        bindBodies();
        gl::bindTexture(kNodes, GL_TEXTURE_BUFFER, nodes_[currentNodes_].nodes.texture());
        bonds_.write(now, feedback_);
    }
    if (contact_) contact_->archive(a);
    if (objects_) objects_->archive(a, [](int) { return false; });
    if (a.reads() && incidents_) {
        incidents_->finish();
        incidents_->forget();
        incidents_->known().copy(bonds_.bonds().buffer());
    }
    IncidentPass::archive(a, world_, incidents_ ? &*incidents_ : nullptr);
}

void ScatterSolver::setIncidents(IncidentRing* ring) {
    incidents_.reset();
    if (!ring) return;
    incidents_.emplace(world_, ContactPass::Storage::Buffers, width_,
                       contact_ ? &*contact_ : nullptr, objects_ ? &*objects_ : nullptr, *ring);
    incidents_->known().copy(bonds_.bonds().buffer());
}

StateView ScatterSolver::view() {
    return {&nodes_[currentNodes_].nodes.texture(),
            kCorners * kNodeTexels,
            kNodeTexels,
            &bonds_.bonds().texture(),
            kBondTexels,
            objects_ ? &objects_->places() : nullptr};
}

void ScatterSolver::finish() {
    glFinish();
    if (incidents_) incidents_->finish();
    if (!contact_) return;
    droppedContacts_ = std::max(droppedContacts_, contact_->dropped());
    raiseHaste(contactHaste_, contact_->haste());
}

void ScatterSolver::push(const Event& event) {
    events_.schedule().add(event, step_);
}

void ScatterSolver::putObject(int object, const ObjectState& state) {
    objects_->put(object, state, step_);
}

void ScatterSolver::advance(int steps) {
    const bool events = events_.write(step_, steps);
    bindBodies();
    gl::bindTexture(kEvents, GL_TEXTURE_BUFFER, events_.texture());
    gl::bindTexture(kLinks, GL_TEXTURE_BUFFER, bonds_.links());
    gl::bindTexture(kForces, GL_TEXTURE_2D, forceTexture_);
    gl::bindTexture(kStresses, GL_TEXTURE_2D, stressTexture_);
    gl::bindTexture(kCumulative, GL_TEXTURE_2D, cumulativeTexture_);
    glPointSize(1);

    for (int i = 0; i < steps; ++i) {
        const bool fracture = breakable_ && step_ % world_.fractureInterval() == 0;
        gl::bindTexture(kNodes, GL_TEXTURE_BUFFER, nodes_[currentNodes_].nodes.texture());
        updateElements(fracture);
        if (contact_) addContacts();
        if (objects_) addObjects(events, i);
        if (incidents_ && contact_) incidents_->addPushes();
        updateConnectivity();
        updateNodes(i);
        if (objects_) objects_->move();
        if (fracture) {
            const TimedPass timed(passTimer_, "bonds and links");
            bonds_.update(feedback_);
            observe(passObserver_, "links", bonds_.linkBuffer());
        }
        ++step_;
        if (incidents_ && incidents_->due(step_)) lookForIncidents();
    }
}

void ScatterSolver::lookForIncidents() {
    const TimedPass timed(passTimer_, "incidents");
    gl::bindTexture(kNodes, GL_TEXTURE_BUFFER, nodes_[currentNodes_].nodes.texture());
    gl::bindTexture(kBonds, GL_TEXTURE_BUFFER, bonds_.bonds().texture());
    incidents_->look(step_);
    incidents_->known().copy(bonds_.bonds().buffer());
}

void ScatterSolver::updateElements(bool fracture) {
    const TimedPass timed(passTimer_, fracture ? "elements and stresses" : "elements");
    glBindFramebuffer(GL_FRAMEBUFFER, elementTarget_.id());
    glViewport(0, 0, width_, height_);
    drawBuffers(fracture ? 2 : 1);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    constexpr float zero[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, zero);
    if (fracture) glClearBufferfv(GL_COLOR, 1, zero);
    drawForces(elementPrograms_[fracture], elementAttributes_,
               kTetrahedraPerCell * world_.cellCount());
    observe(passObserver_, "elements", elementTarget_, 0, width_, world_.nodeCount());
    if (fracture)
        observe(passObserver_, "stresses", elementTarget_, 1, width_,
                SUNDER_STRESS_TEXELS * kTetrahedraPerCell * world_.cellCount());
}

/// Adds to the bound targets; leaves the inverse masses in the first one's alpha alone.
void ScatterSolver::drawForces(const gl::Program& program, const gl::VertexArray& attributes,
                               int count) {
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    program.use();
    glBindVertexArray(attributes.id());
    glDrawArrays(GL_POINTS, 0, count);
    glDisable(GL_BLEND);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void ScatterSolver::addContacts() {
    contact_->update(step_, passTimer_);
    const TimedPass timed(passTimer_, "contacts");
    contact_->push();
    glBindFramebuffer(GL_FRAMEBUFFER, elementTarget_.id());
    glViewport(0, 0, width_, height_);
    drawBuffers(1);
    drawForces(contactProgram_, noAttributes_, world_.cellCount());
    observe(passObserver_, "contacts", elementTarget_, 0, width_, world_.nodeCount());
}

void ScatterSolver::addObjects(bool events, int stepInFrame) {
    const TimedPass timed(passTimer_, "objects");
    for (const Throw& thrown : world_.throws())
        if (thrown.step == step_) putObject(thrown.object, thrown.state);
    if (events && events_.schedule().nextBlast(step_) == step_) objects_->accelerate(stepInFrame);
    objects_->push(step_);
    glBindFramebuffer(GL_FRAMEBUFFER, elementTarget_.id());
    glViewport(0, 0, width_, height_);
    drawBuffers(1);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    objects_->drawForces();
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    observe(passObserver_, "objects", elementTarget_, 0, width_, world_.nodeCount());
}

void ScatterSolver::updateConnectivity() {
    const TimedPass timed(passTimer_, "connectivity");
    glBindFramebuffer(GL_FRAMEBUFFER, cumulativeTarget_.id());
    glViewport(0, 0, width_, height_);
    connectivityProgram_.use();
    glBindVertexArray(noAttributes_.id());
    glDrawArrays(GL_POINTS, 0, world_.nodeCount());
    observe(passObserver_, "connectivity", cumulativeTarget_, 0, width_, world_.nodeCount());
}

void ScatterSolver::updateNodes(int stepInFrame) {
    const TimedPass timed(passTimer_, "nodes");
    nodeProgram_.use();
    glUniform1f(stepInFrameUniform_, static_cast<float>(stepInFrame));
    const int next = 1 - currentNodes_;
    feedback_.run(nodeProgram_, nodes_[currentNodes_].attributes, {&nodes_[next].nodes.buffer()},
                  world_.nodeCount());
    currentNodes_ = next;
}

}  // namespace sunder::gpu
