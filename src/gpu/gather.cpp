#include "gpu/gather.hpp"

#include "gpu/layout.hpp"

namespace sunder::gpu {
namespace {

constexpr std::size_t kForceBytesPerCell = sizeof(vec4) * kCorners;
constexpr std::size_t kStressBytesPerCell =
    sizeof(vec4) * 7;  // SUNDER_STRESS_RECORD in glsl/gather/stress.glsl

}  // namespace

GatherSolver::GatherSolver(const World& world, const WorldBuffers& buffers)
    : world_(world),
      buffers_(buffers),
      bonds_(world, "gather/fracture.vert"),
      events_(world),
      nodes_{NodeBuffer(world), NodeBuffer(world)},
      forceBuffer_(kForceBytesPerCell * world.cellCount(), nullptr, GL_DYNAMIC_COPY, "forces"),
      stressBuffer_(kStressBytesPerCell * world.cellCount(), nullptr, GL_DYNAMIC_COPY, "stresses"),
      forceTexture_(gl::makeBufferTexture(forceBuffer_, GL_RGBA32F, "forces")),
      stressTexture_(gl::makeBufferTexture(stressBuffer_, GL_RGBA32F, "stresses")) {
    elementPrograms_[0] = gl::Program({.vertex = "gather/element.vert",
                                       .defines = {{"FRACTURE", "0"}},
                                       .feedback = {"newForces"}});
    // gl_NextBuffer: stresses go to a buffer of their own, so that forces lie the same on every
    // step.
    elementPrograms_[1] = gl::Program({.vertex = "gather/element.vert",
                                       .defines = {{"FRACTURE", "1"}},
                                       .feedback = {"newForces", "gl_NextBuffer", "newStress"}});
    for (const int events : {0, 1})
        nodePrograms_[events] = gl::Program({.vertex = "gather/node.vert",
                                             .defines = {{"EVENTS", std::to_string(events)}},
                                             .feedback = {"newNodes"}});
    for (const auto* pair : {&elementPrograms_, &nodePrograms_})
        for (const gl::Program& program : *pair) setConstants(program, world);
    stepInFrameUniform_ = nodePrograms_[1].uniform("stepInFrame");
    setState(world.initialState());
}

State GatherSolver::state() const {
    State state;
    state.step = step_;
    nodes_[current_].read(state);
    bonds_.bonds().read(state);
    return state;
}

void GatherSolver::setState(const State& state) {
    step_ = state.step;
    nodes_[current_].write(state);
    bindWorld(buffers_);
    bonds_.write(state, feedback_);
}

StateView GatherSolver::view() const {
    return {&nodes_[current_].texture(), &bonds_.bonds().texture()};
}

void GatherSolver::finish() {
    glFinish();
}

void GatherSolver::advance(int steps) {
    const bool events = events_.write(step_, steps);
    bindWorld(buffers_);
    gl::bindTexture(kEvents, GL_TEXTURE_BUFFER, events_.texture());
    gl::bindTexture(kLinks, GL_TEXTURE_BUFFER, bonds_.links());
    gl::bindTexture(kForces, GL_TEXTURE_BUFFER, forceTexture_);
    gl::bindTexture(kStresses, GL_TEXTURE_BUFFER, stressTexture_);
    for (int i = 0; i < steps; ++i, ++step_) {
        const bool fracture =
            bonds_.breakable() && step_ % world_.description().fractureInterval == 0;
        gl::bindTexture(kNodes, GL_TEXTURE_BUFFER, nodes_[current_].texture());
        updateElements(fracture);
        updateNodes(events, i);
        if (!fracture) continue;
        const TimedPass timed(passTimer_, "bonds and links");
        bonds_.update(feedback_);
    }
}

void GatherSolver::updateElements(bool fracture) {
    const TimedPass timed(passTimer_, fracture ? "elements and stresses" : "elements");
    if (fracture)
        feedback_.run(elementPrograms_[1], {&forceBuffer_, &stressBuffer_}, world_.cellCount());
    else
        feedback_.run(elementPrograms_[0], {&forceBuffer_}, world_.cellCount());
}

void GatherSolver::updateNodes(bool events, int stepInFrame) {
    const TimedPass timed(passTimer_, "nodes");
    if (events) {
        nodePrograms_[1].use();
        glUniform1f(stepInFrameUniform_, static_cast<float>(stepInFrame));
    }
    feedback_.run(nodePrograms_[events], {&nodes_[1 - current_].buffer()}, world_.cellCount());
    current_ = 1 - current_;
}

}  // namespace sunder::gpu
