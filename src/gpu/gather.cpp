#include "gpu/gather.hpp"

namespace sunder::gpu {
namespace {

gl::Program texelProgram(const char* fragment, gl::Defines defines = {}) {
    return gl::Program(
        {.vertex = "gather/texels.vert", .fragment = fragment, .defines = std::move(defines)});
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
      stresses_(breakable_ ? world.cellCount() : 1, columns_, SUNDER_STRESS_LAYERS, "stresses"),
      links_(world.cellCount(), columns_, SUNDER_LINK_TEXELS, "links"),
      forceProgram_(texelProgram("gather/element.frag", {{"STRESSES", "0"}})),
      stressProgram_(texelProgram("gather/element.frag", {{"STRESSES", "1"}})),
      bondProgram_(texelProgram("gather/fracture.frag")),
      linkProgram_(texelProgram("gather/links.frag")),
      nodePrograms_{texelProgram("gather/node.frag", {{"EVENTS", "0"}}),
                    texelProgram("gather/node.frag", {{"EVENTS", "1"}})} {
    for (const gl::Program* program : {&forceProgram_, &stressProgram_, &bondProgram_,
                                       &linkProgram_, &nodePrograms_[0], &nodePrograms_[1]})
        setConstants(*program, world, columns_);
    stepInFrameUniform_ = nodePrograms_[1].uniform("stepInFrame");
    setState(world.initialState());
}

State GatherSolver::state() const {
    State state = world_.initialState();
    state.step = step_;
    const std::vector<vec4> u = nodes_[currentNodes_].read(0), v = nodes_[currentNodes_].read(1);
    for (int node = 0; node < world_.nodeCount(); ++node) {
        state.displacement[node] = {u[node].x, u[node].y, u[node].z};
        state.velocity[node] = {v[node].x, v[node].y, v[node].z};
    }
    const std::vector<vec4> damage = bonds_[currentBonds_].read(0),
                            slow = bonds_[currentBonds_].read(1);
    for (int cell = 0; cell < world_.cellCount(); ++cell)
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            state.damage[kBondsPerCell * cell + axis] = damage[cell][axis];
            state.slow[kBondsPerCell * cell + axis] = slow[cell][axis];
        }
    return state;
}

void GatherSolver::setState(const State& state) {
    step_ = state.step;
    std::vector<vec4> u, v, damage, slow;
    for (int node = 0; node < world_.nodeCount(); ++node) {
        u.push_back(toVec4(state.displacement[node], world_.restPosition(node)[1]));
        v.push_back(toVec4(state.velocity[node], 0));
    }
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        const double *d = &state.damage[kBondsPerCell * cell],
                     *s = &state.slow[kBondsPerCell * cell];
        damage.push_back(toVec4({d[0], d[1], d[2]}, 0));
        slow.push_back(toVec4({s[0], s[1], s[2]}, 0));
    }
    nodes_[currentNodes_].write(0, u);
    nodes_[currentNodes_].write(1, v);
    bonds_[currentBonds_].write(0, damage);
    bonds_[currentBonds_].write(1, slow);
    bindWorld(buffers_);
    updateLinks();
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

void GatherSolver::advance(int steps) {
    const bool events = events_.write(step_, steps);
    bindWorld(buffers_);
    gl::bindTexture(kEvents, GL_TEXTURE_BUFFER, events_.texture());
    gl::bindTexture(kLinks, GL_TEXTURE_2D_ARRAY, links_.texture());
    gl::bindTexture(kForces, GL_TEXTURE_2D_ARRAY, forces_.texture());
    gl::bindTexture(kStresses, GL_TEXTURE_2D_ARRAY, stresses_.texture());
    for (int i = 0; i < steps; ++i, ++step_) {
        gl::bindTexture(kNodes, GL_TEXTURE_2D_ARRAY, nodes_[currentNodes_].texture());
        {
            const TimedPass timed(passTimer_, "elements");
            forces_.fill(forceProgram_);
        }
        // Stresses are those before the nodes move; what they break shows in the links of the next
        // step.
        const bool fracture = breakable_ && step_ % world_.description().fractureInterval == 0;
        if (fracture) updateBonds();
        updateNodes(events, i);
        if (fracture) updateLinks();
    }
}

void GatherSolver::updateBonds() {
    {
        const TimedPass timed(passTimer_, "stresses");
        stresses_.fill(stressProgram_);
    }
    const TimedPass timed(passTimer_, "bonds");
    gl::bindTexture(kBonds, GL_TEXTURE_2D_ARRAY, bonds_[currentBonds_].texture());
    currentBonds_ = 1 - currentBonds_;
    bonds_[currentBonds_].fill(bondProgram_);
}

void GatherSolver::updateLinks() {
    const TimedPass timed(passTimer_, "links");
    gl::bindTexture(kBonds, GL_TEXTURE_2D_ARRAY, bonds_[currentBonds_].texture());
    links_.fill(linkProgram_);
}

void GatherSolver::updateNodes(bool events, int stepInFrame) {
    const TimedPass timed(passTimer_, "nodes");
    const gl::Program& program = nodePrograms_[events];
    program.use();
    if (events) glUniform1f(stepInFrameUniform_, static_cast<float>(stepInFrame));
    currentNodes_ = 1 - currentNodes_;
    nodes_[currentNodes_].fill(program);
}

}  // namespace sunder::gpu
