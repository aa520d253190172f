#include "gpu/gather.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/sleep.hpp"

namespace sunder::gpu {
namespace {

gl::Defines breakDefines(const World& world) {
    return {{"BONDS_BREAK", world.bondsBreak() ? "1" : "0"},
            {"CELLS_BREAK", world.cellsBreak() ? "1" : "0"}};
}

gl::Defines with(gl::Defines defines, const char* name, const char* value) {
    defines.push_back({name, value});
    return defines;
}

TexelRange cellsOf(const World& world, int index) {
    const Body& body = world.bodies()[index];
    return {body.firstCell, body.firstCell + body.cellCount()};
}

TexelRange nodesOf(TexelRange cells) {
    return {kCorners * cells.first, kCorners * cells.end};
}

/// Layers of glsl/gather/stress.glsl.
int stressLayers(const World& world) {
    return std::max(1, 6 * world.bondsBreak() + world.cellsBreak());
}

}  // namespace

GatherSolver::GatherSolver(const World& world, const WorldBuffers& buffers)
    : world_(world),
      buffers_(buffers),
      breakable_(world.breakable()),
      columns_(texelColumns(world.nodeCount())),
      events_(world),
      nodes_{TexelTarget(world.nodeCount(), columns_, 2, "nodes"),
             TexelTarget(world.nodeCount(), columns_, 2, "nodes")},
      bonds_{TexelTarget(world.cellCount(), columns_, 2, "bonds"),
             TexelTarget(world.cellCount(), columns_, 2, "bonds")},
      forces_(world.cellCount(), columns_, kCorners, "forces"),
      stresses_(breakable_ ? world.cellCount() : 1, columns_, stressLayers(world), "stresses"),
      links_(world.cellCount(), columns_, SUNDER_LINK_TEXELS, "links"),
      forceProgram_(texelProgram("gather/element.frag", forces_, {{"STRESSES", "0"}})),
      linkProgram_(texelProgram("gather/links.frag", links_)),
      nodePrograms_{texelProgram("gather/node.frag", nodes_[0], {{"EVENTS", "0"}}),
                    texelProgram("gather/node.frag", nodes_[0], {{"EVENTS", "1"}})},
      stillNodeProgram_(texelProgram("gather/still.frag", nodes_[0], {{"NODES", "1"}})),
      stillBondProgram_(texelProgram("gather/still.frag", bonds_[0], {{"NODES", "0"}})),
      stepInFrameUniform_(nodePrograms_[1].uniform("stepInFrame")),
      bodies_(world.bodies().size(), BodyState::Awake),
      awake_(world.bodies().size()),
      monitor_(world, columns_) {
    if (breakable_) {
        const gl::Defines defines = breakDefines(world);
        stressProgram_ =
            texelProgram("gather/element.frag", stresses_, with(defines, "STRESSES", "1"));
        bondProgram_ = texelProgram("gather/fracture.frag", bonds_[0], defines);
        bondWatchUniform_ = bondProgram_.uniform("newWatch");
    }
    for (int i = 0; i < 2; ++i) nodeWatchUniforms_[i] = nodePrograms_[i].uniform("newWatch");
    setState(world.initialState());
}

gl::Program GatherSolver::texelProgram(const char* fragment, const TexelTarget& target,
                                       gl::Defines defines) const {
    gl::Program program(
        {.vertex = "gather/texels.vert", .fragment = fragment, .defines = std::move(defines)});
    setConstants(program, world_, columns_);
    target.prepare(program);
    return program;
}

State GatherSolver::state() const {
    State state = world_.initialState();
    state.step = step_;
    read({0, world_.cellCount()}, state);
    return state;
}

void GatherSolver::setState(const State& state) {
    step_ = state.step;
    write({0, world_.cellCount()}, state);
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
        if (!holds(body)) continue;
        bodies_[body] = BodyState::Awake;
        monitor_.disturb(body, step_);
    }
    bodiesChanged();
    bindInputs();
    updateLinks();
}

void GatherSolver::adopt(int body, const State& state) {
    write(cellsOf(world_, body), state);
    bodies_[body] = BodyState::Awake;
    monitor_.disturb(body, step_);
    bodiesChanged();
    BodyRanges own(1);
    own.set(world_, {body}, columns_);
    bindInputs();
    links_.fill(linkProgram_, own.cells);
}

void GatherSolver::release(int body, State& state) {
    read(cellsOf(world_, body), state);
    bodies_[body] = BodyState::Elsewhere;
    bodiesChanged();
}

void GatherSolver::show(int body, const State& state) {
    write(cellsOf(world_, body), state);
}

void GatherSolver::write(TexelRange cells, const State& state) {
    const TexelRange nodes = nodesOf(cells);
    std::vector<vec4> u, v, damage, slow;
    for (int node = nodes.first; node < nodes.end; ++node) {
        u.push_back(toVec4(state.displacement[node], world_.restPosition(node)[1]));
        v.push_back(toVec4(state.velocity[node], 0));
    }
    for (int cell = cells.first; cell < cells.end; ++cell) {
        const double *d = &state.damage[kBondsPerCell * cell],
                     *s = &state.slow[kBondsPerCell * cell];
        damage.push_back(toVec4({d[0], d[1], d[2]}, 0));
        slow.push_back(toVec4({s[0], s[1], s[2]}, 0));
    }
    nodes_[currentNodes_].write(0, nodes.first, u);
    nodes_[currentNodes_].write(1, nodes.first, v);
    bonds_[currentBonds_].write(0, cells.first, damage);
    bonds_[currentBonds_].write(1, cells.first, slow);
}

void GatherSolver::read(TexelRange cells, State& state) const {
    const TexelRange nodes = nodesOf(cells);
    const std::vector<vec4> u = nodes_[currentNodes_].read(0, nodes),
                            v = nodes_[currentNodes_].read(1, nodes);
    for (int node = nodes.first; node < nodes.end; ++node) {
        const vec4 &from = u[node - nodes.first], &rate = v[node - nodes.first];
        state.displacement[node] = {from.x, from.y, from.z};
        state.velocity[node] = {rate.x, rate.y, rate.z};
    }
    const std::vector<vec4> damage = bonds_[currentBonds_].read(0, cells),
                            slow = bonds_[currentBonds_].read(1, cells);
    for (int cell = cells.first; cell < cells.end; ++cell)
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            state.damage[kBondsPerCell * cell + axis] = damage[cell - cells.first][axis];
            state.slow[kBondsPerCell * cell + axis] = slow[cell - cells.first][axis];
        }
}

/// Bodies that are neighbours in the numbering become one range.
void GatherSolver::BodyRanges::set(const World& world, const std::vector<int>& bodies,
                                   int columns) {
    std::vector<TexelRange> cellRanges, nodeRanges;
    for (const int index : bodies) {
        const TexelRange own = cellsOf(world, index);
        if (!cellRanges.empty() && cellRanges.back().end == own.first)
            cellRanges.back().end = own.end;
        else
            cellRanges.push_back(own);
    }
    for (const TexelRange& range : cellRanges) nodeRanges.push_back(nodesOf(range));
    cells.set(cellRanges, columns);
    nodes.set(nodeRanges, columns);
}

void GatherSolver::Copy::update(const TexelTarget& from, int layer, const char* what) {
    if (buffer.size() == 0) {
        buffer = gl::Buffer(from.bufferBytes(), nullptr, GL_STREAM_COPY, what);
        texture = gl::makeBufferTexture(buffer, GL_RGBA32F, what);
    }
    from.copy(layer, buffer);
}

StateView GatherSolver::view() {
    drawnNodes_.update(nodes_[currentNodes_], 0, "drawn nodes");
    drawnDamage_.update(bonds_[currentBonds_], 0, "drawn bonds");
    return {&drawnNodes_.texture, 1, &drawnDamage_.texture, 1};
}

void GatherSolver::finish() {
    glFinish();
}

void GatherSolver::bindInputs() const {
    bindWorld(buffers_);
    gl::bindTexture(kEvents, GL_TEXTURE_BUFFER, events_.texture());
    gl::bindTexture(kLinks, GL_TEXTURE_2D_ARRAY, links_.texture());
    gl::bindTexture(kForces, GL_TEXTURE_2D_ARRAY, forces_.texture());
    gl::bindTexture(kStresses, GL_TEXTURE_2D_ARRAY, stresses_.texture());
    gl::bindTexture(kNodes, GL_TEXTURE_2D_ARRAY, nodes_[currentNodes_].texture());
    gl::bindTexture(kBonds, GL_TEXTURE_2D_ARRAY, bonds_[currentBonds_].texture());
}

void GatherSolver::advance(int steps) {
    const bool events = events_.write(step_, steps);
    bindInputs();
    for (int i = 0; i < steps; ++i, ++step_) {
        if (step_ >= nextWake_) wakePushed();
        if (awake_.cells.rectangles() == 0) continue;
        if (step_ % monitor_.interval() == 0) watch();
        {
            const TimedPass timed(passTimer_, "elements");
            forces_.fill(forceProgram_, awake_.cells);
        }
        // Stresses are those before the nodes move; what they break shows in the links of the next
        // step.
        const bool fracture = breakable_ && step_ % world_.description().fractureInterval == 0;
        if (fracture) updateBonds();
        updateNodes(events, i);
        if (fracture) updateLinks();
    }
    // The GPU begins at once, not when the queue is full: the CPU may have work of its own.
    glFlush();
}

void GatherSolver::updateBonds() {
    {
        const TimedPass timed(passTimer_, "stresses");
        stresses_.fill(stressProgram_, awake_.cells);
    }
    const TimedPass timed(passTimer_, "bonds");
    bondProgram_.use();
    glUniform1i(bondWatchUniform_, std::exchange(newBondWatch_, false));
    currentBonds_ = 1 - currentBonds_;
    bonds_[currentBonds_].fill(bondProgram_, awake_.cells);
    gl::bindTexture(kBonds, GL_TEXTURE_2D_ARRAY, bonds_[currentBonds_].texture());
}

void GatherSolver::updateLinks() {
    const TimedPass timed(passTimer_, "links");
    links_.fill(linkProgram_, awake_.cells);
}

void GatherSolver::updateNodes(bool events, int stepInFrame) {
    const TimedPass timed(passTimer_, "nodes");
    const gl::Program& program = nodePrograms_[events];
    program.use();
    glUniform1i(nodeWatchUniforms_[events], std::exchange(newNodeWatch_, false));
    if (events) glUniform1f(stepInFrameUniform_, static_cast<float>(stepInFrame));
    currentNodes_ = 1 - currentNodes_;
    nodes_[currentNodes_].fill(program, awake_.nodes);
    gl::bindTexture(kNodes, GL_TEXTURE_2D_ARRAY, nodes_[currentNodes_].texture());
}

/// Looks for bodies that have come to rest.
void GatherSolver::watch() {
    std::vector<int> calm;
    {
        const TimedPass timed(passTimer_, "rest");
        calm = monitor_.look(step_);
    }
    newNodeWatch_ = newBondWatch_ = true;
    std::erase_if(calm, [&](int body) { return bodies_[body] != BodyState::Awake; });
    if (!calm.empty()) fallAsleep(calm);
}

/// Their velocities become zero, and both halves of the ping-pong the same: the passes no longer
/// touch them.
void GatherSolver::fallAsleep(const std::vector<int>& calm) {
    BodyRanges falling(calm.size());
    falling.set(world_, calm, columns_);
    const auto copy = [](const gl::Program& program, const TexelTarget& from, const TexelTarget& to,
                         const TexelRanges& ranges) {
        gl::bindTexture(kRecords, GL_TEXTURE_2D_ARRAY, from.texture());
        to.fill(program, ranges);
    };
    const TexelTarget &nodes = nodes_[currentNodes_], &otherNodes = nodes_[1 - currentNodes_];
    copy(stillNodeProgram_, nodes, otherNodes, falling.nodes);
    copy(stillNodeProgram_, otherNodes, nodes, falling.nodes);
    copy(stillBondProgram_, bonds_[currentBonds_], bonds_[1 - currentBonds_], falling.cells);
    for (const int body : calm) bodies_[body] = BodyState::Asleep;
    bodiesChanged();
}

void GatherSolver::wakePushed() {
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body)
        if (bodies_[body] == BodyState::Asleep && pushedWithin(world_, body, step_, step_ + 1)) {
            bodies_[body] = BodyState::Awake;
            monitor_.disturb(body, step_);
        }
    bodiesChanged();
}

void GatherSolver::bodiesChanged() {
    std::vector<int> awake;
    nextWake_ = std::numeric_limits<std::int64_t>::max();
    for (int index = 0; index < static_cast<int>(bodies_.size()); ++index) {
        if (bodies_[index] == BodyState::Awake) awake.push_back(index);
        if (bodies_[index] == BodyState::Asleep)
            nextWake_ = std::min(nextWake_, nextPush(world_, index, step_));
    }
    awake_.set(world_, awake, columns_);
}

}  // namespace sunder::gpu
