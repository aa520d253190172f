#include "gpu/scatter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/tetrahedra.hpp"
#include "gpu/layout.hpp"

namespace sunder::gpu {
namespace {

// Texture units. One meaning each, so that a pass only binds what changed.
enum Unit {
    kCells,
    kBodies,
    kRest,
    kNodes,
    kBonds,
    kEvents,
    kLinks,
    kForces,
    kStresses,
    kCumulative,
    kUnitCount
};
constexpr const char* kSamplers[kUnitCount] = {"cells",    "bodies",          "rest",  "nodes",
                                               "bonds",    "events",          "links", "forces",
                                               "stresses", "cumulativeForces"};
constexpr int kLawBinding = 0;
constexpr int kStressTexels = 3;  // SUNDER_STRESS_TEXELS in glsl/scatter/textures.glsl

/// The finite element structure of the thesis, chapter 6.
struct ElementVertex {
    std::int32_t nodes[4];
    glm::mat3 inverseRest;
};

void attribute(GLuint location, int components, std::size_t stride, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
}

/// A framebuffer with these colour attachments; throws when the driver cannot draw into them.
gl::Framebuffer makeTarget(std::initializer_list<const gl::Texture*> textures) {
    gl::Framebuffer framebuffer = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    GLenum attachment = GL_COLOR_ATTACHMENT0;
    for (const gl::Texture* texture : textures)
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment++, GL_TEXTURE_2D, texture->id(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw ContextError(
            "the driver cannot draw into floating-point textures, which the scatter solver needs");
    return framebuffer;
}

void drawBuffers(int count) {
    constexpr GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(count, both);
}

}  // namespace

ScatterSolver::ScatterSolver(const World& world, const WorldBuffers& buffers)
    : world_(world),
      buffers_(buffers),
      height_((std::max(kCorners, kStressTexels * kTetrahedraPerCell) * world.cellCount() +
               SUNDER_TEXTURE_WIDTH - 1) /
              SUNDER_TEXTURE_WIDTH),
      nodes_{
          {{NodeBuffer(world), gl::makeVertexArray()}, {NodeBuffer(world), gl::makeVertexArray()}}},
      bonds_{{{BondBuffer(world), gl::makeVertexArray()},
              {BondBuffer(world), gl::makeVertexArray()}}} {
    makeElementBuffers();
    makeTargets();
    makePrograms();
    setState(world.initialState());
}

void ScatterSolver::makeElementBuffers() {
    std::vector<ElementVertex> elements;
    elements.reserve(std::size_t{kTetrahedraPerCell} * world_.cellCount());
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
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
    }
    elementBuffer_ = gl::makeBuffer<ElementVertex>(elements, GL_STATIC_DRAW, "finite elements");
    elementAttributes_ = gl::makeVertexArray();
    noAttributes_ = gl::makeVertexArray();
    glBindVertexArray(elementAttributes_.id());
    glBindBuffer(GL_ARRAY_BUFFER, elementBuffer_.id());
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(0, 4, GL_INT, sizeof(ElementVertex), nullptr);
    for (GLuint column = 0; column < 3; ++column)
        attribute(1 + column, 3, sizeof(ElementVertex),
                  offsetof(ElementVertex, inverseRest) + column * sizeof(glm::vec3));

    std::vector<vec4> strengths(world_.cellCount(), vec4(0));
    for (int cell = 0; cell < world_.cellCount(); ++cell)
        for (int axis = 0; axis < kBondsPerCell; ++axis)
            strengths[cell][axis] = std::min(world_.bondStrength(kBondsPerCell * cell + axis),
                                             static_cast<float>(SUNDER_UNBREAKABLE));
    strengthBuffer_ = gl::makeBuffer<vec4>(strengths, GL_STATIC_DRAW, "bond strengths");

    for (const NodeSide& side : nodes_) {
        glBindVertexArray(side.attributes.id());
        glBindBuffer(GL_ARRAY_BUFFER, side.nodes.buffer().id());
        attribute(0, 4, sizeof(NodeRecord), offsetof(NodeRecord, displacement));
        attribute(1, 4, sizeof(NodeRecord), offsetof(NodeRecord, velocity));
    }
    for (const BondSide& side : bonds_) {
        glBindVertexArray(side.attributes.id());
        glBindBuffer(GL_ARRAY_BUFFER, side.bonds.buffer().id());
        attribute(0, 4, sizeof(BondRecord), offsetof(BondRecord, damage));
        attribute(1, 4, sizeof(BondRecord), offsetof(BondRecord, slow));
        glBindBuffer(GL_ARRAY_BUFFER, strengthBuffer_.id());
        attribute(2, 4, sizeof(vec4), 0);
    }

    linkBuffer_ =
        gl::Buffer(std::size_t{8} * world_.cellCount(), nullptr, GL_DYNAMIC_COPY, "link masks");
    linkTexture_ = gl::makeBufferTexture(linkBuffer_, GL_RG32UI, "link masks");
    const std::size_t eventCount = std::max<std::size_t>(1, world_.events().size());
    eventBuffer_ = gl::Buffer(sizeof(EventRecord) * eventCount, nullptr, GL_DYNAMIC_DRAW, "events");
    eventTexture_ = gl::makeBufferTexture(eventBuffer_, GL_RGBA32F, "events");
}

void ScatterSolver::makeTargets() {
    forceTexture_ = gl::makeTexture2D(SUNDER_TEXTURE_WIDTH, height_, GL_RGBA32F, "force texture");
    stressTexture_ = gl::makeTexture2D(SUNDER_TEXTURE_WIDTH, height_, GL_RGBA32F, "stress texture");
    cumulativeTexture_ =
        gl::makeTexture2D(SUNDER_TEXTURE_WIDTH, height_, GL_RGBA32F, "cumulative force texture");
    discardTexture_ = gl::makeTexture2D(1, 1, GL_RGBA8, "discarded texels");
    elementTarget_ = makeTarget({&forceTexture_, &stressTexture_});
    cumulativeTarget_ = makeTarget({&cumulativeTexture_});
    discardTarget_ = makeTarget({&discardTexture_});

    // The force texture's alpha carries the inverse mass of each node's copy and is masked from
    // here on: 0 anchors the node.
    std::vector<vec4> texels(std::size_t{SUNDER_TEXTURE_WIDTH} * height_, vec4(0));
    for (int node = 0; node < world_.nodeCount(); ++node)
        if (!world_.anchored(node) && world_.nodeMass(node) > 0)
            texels[node].w = static_cast<float>(1 / world_.nodeMass(node));
    glBindTexture(GL_TEXTURE_2D, forceTexture_.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, SUNDER_TEXTURE_WIDTH, height_, GL_RGBA, GL_FLOAT,
                    texels.data());
}

void ScatterSolver::makePrograms() {
    for (const int fracture : {0, 1})
        elementPrograms_[fracture] =
            gl::Program({.vertex = "scatter/element.vert",
                         .geometry = "scatter/element.geom",
                         .fragment = "scatter/element.frag",
                         .defines = {{"FRACTURE", std::to_string(fracture)}},
                         .attributes = {{"nodeIndices", 0}, {"inverseRest", 1}}});
    connectivityProgram_ = gl::Program(
        {.vertex = "scatter/connectivity.vert", .fragment = "scatter/connectivity.frag"});
    nodeProgram_ = gl::Program({.vertex = "scatter/node.vert",
                                .feedback = {"newDisplacement", "newVelocity"},
                                .attributes = {{"displacement", 0}, {"velocity", 1}}});
    fractureProgram_ = gl::Program({.vertex = "scatter/fracture.vert",
                                    .feedback = {"newDamage", "newSlow"},
                                    .attributes = {{"damage", 0}, {"slow", 1}, {"strength", 2}}});
    linkProgram_ = gl::Program({.vertex = "scatter/links.vert", .feedback = {"newLinks"}});

    const auto h = static_cast<float>(world_.step());
    for (const gl::Program* program :
         {&elementPrograms_[0], &elementPrograms_[1], &connectivityProgram_, &nodeProgram_,
          &fractureProgram_, &linkProgram_}) {
        program->bindUniformBlock("ElementLaws", kLawBinding);
        for (int unit = 0; unit < kUnitCount; ++unit) program->bindSampler(kSamplers[unit], unit);
        glUniform1f(program->uniform("targetHeight"), static_cast<float>(height_));
        glUniform1f(program->uniform("stepSize"), h);
        glUniform1f(program->uniform("interval"),
                    static_cast<float>(world_.description().fractureInterval) * h);
        glUniform2f(program->uniform("ground"), world_.description().ground ? 1.0f : 0.0f,
                    static_cast<float>(world_.description().groundFriction));
    }
    stepInFrameUniform_ = nodeProgram_.uniform("stepInFrame");
}

State ScatterSolver::state() const {
    State state;
    state.step = step_;
    nodes_[currentNodes_].nodes.read(state);
    bonds_[currentBonds_].bonds.read(state);
    return state;
}

void ScatterSolver::setState(const State& state) {
    step_ = state.step;
    nodes_[currentNodes_].nodes.write(state);
    bonds_[currentBonds_].bonds.write(state);
    gl::bindTexture(kCells, GL_TEXTURE_BUFFER, buffers_.cells());
    gl::bindTexture(kBodies, GL_TEXTURE_BUFFER, buffers_.bodies());
    glBindBufferBase(GL_UNIFORM_BUFFER, kLawBinding, buffers_.laws().id());
    updateLinks();
}

StateView ScatterSolver::view() const {
    return {&nodes_[currentNodes_].nodes.texture(), &bonds_[currentBonds_].bonds.texture()};
}

void ScatterSolver::finish() {
    glFinish();
}

void ScatterSolver::advance(int steps) {
    writeEvents();
    // Another user of the context may have used these units since.
    gl::bindTexture(kCells, GL_TEXTURE_BUFFER, buffers_.cells());
    gl::bindTexture(kBodies, GL_TEXTURE_BUFFER, buffers_.bodies());
    gl::bindTexture(kRest, GL_TEXTURE_BUFFER, buffers_.rest());
    gl::bindTexture(kEvents, GL_TEXTURE_BUFFER, eventTexture_);
    gl::bindTexture(kLinks, GL_TEXTURE_BUFFER, linkTexture_);
    gl::bindTexture(kForces, GL_TEXTURE_2D, forceTexture_);
    gl::bindTexture(kStresses, GL_TEXTURE_2D, stressTexture_);
    gl::bindTexture(kCumulative, GL_TEXTURE_2D, cumulativeTexture_);
    glBindBufferBase(GL_UNIFORM_BUFFER, kLawBinding, buffers_.laws().id());
    glViewport(0, 0, SUNDER_TEXTURE_WIDTH, height_);
    glPointSize(1);

    for (int i = 0; i < steps; ++i, ++step_) {
        const bool fracture = step_ % world_.description().fractureInterval == 0;
        gl::bindTexture(kNodes, GL_TEXTURE_BUFFER, nodes_[currentNodes_].nodes.texture());
        updateElements(fracture);
        updateConnectivity();
        updateNodes(i);
        if (fracture) {
            updateFracture();
            updateLinks();
        }
    }
}

/// Event times count steps from the start of this call: single precision stays exact however long
/// the world has run.
void ScatterSolver::writeEvents() {
    std::vector<EventRecord> records;
    for (const Event& event : world_.events()) {
        const auto toFloat = [](double value) { return static_cast<float>(value); };
        const Vec3& a = event.acceleration;
        const auto now = static_cast<double>(step_);
        records.push_back({{event.point[0], event.point[1], event.point[2], event.radius},
                           {toFloat(a[0]), toFloat(a[1]), toFloat(a[2]), 0},
                           {toFloat(event.start - now), toFloat(event.end - now), 0, 0}});
    }
    if (!records.empty())
        eventBuffer_.write(0, sizeof(EventRecord) * records.size(), records.data());
}

void ScatterSolver::updateElements(bool fracture) {
    glBindFramebuffer(GL_FRAMEBUFFER, elementTarget_.id());
    drawBuffers(fracture ? 2 : 1);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    constexpr float zero[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, zero);
    if (fracture) glClearBufferfv(GL_COLOR, 1, zero);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    elementPrograms_[fracture].use();
    glBindVertexArray(elementAttributes_.id());
    glDrawArrays(GL_POINTS, 0, kTetrahedraPerCell * world_.cellCount());
    glDisable(GL_BLEND);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void ScatterSolver::updateConnectivity() {
    glBindFramebuffer(GL_FRAMEBUFFER, cumulativeTarget_.id());
    connectivityProgram_.use();
    glBindVertexArray(noAttributes_.id());
    glDrawArrays(GL_POINTS, 0, world_.nodeCount());
}

void ScatterSolver::updateNodes(int stepInFrame) {
    nodeProgram_.use();
    glUniform1f(stepInFrameUniform_, static_cast<float>(stepInFrame));
    const int next = 1 - currentNodes_;
    feedback(nodeProgram_, nodes_[currentNodes_].attributes, nodes_[next].nodes.buffer(),
             world_.nodeCount());
    currentNodes_ = next;
}

void ScatterSolver::updateFracture() {
    const int next = 1 - currentBonds_;
    feedback(fractureProgram_, bonds_[currentBonds_].attributes, bonds_[next].bonds.buffer(),
             world_.cellCount());
    currentBonds_ = next;
}

void ScatterSolver::updateLinks() {
    gl::bindTexture(kBonds, GL_TEXTURE_BUFFER, bonds_[currentBonds_].bonds.texture());
    feedback(linkProgram_, noAttributes_, linkBuffer_, world_.cellCount());
}

void ScatterSolver::feedback(const gl::Program& program, const gl::VertexArray& attributes,
                             const gl::Buffer& target, int count) {
    // Nothing is rasterised, but without a complete framebuffer the draw would fail and capture
    // nothing.
    glBindFramebuffer(GL_FRAMEBUFFER, discardTarget_.id());
    glEnable(GL_RASTERIZER_DISCARD);
    program.use();
    glBindVertexArray(attributes.id());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, target.id());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, count);
    glEndTransformFeedback();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glDisable(GL_RASTERIZER_DISCARD);
}

}  // namespace sunder::gpu
