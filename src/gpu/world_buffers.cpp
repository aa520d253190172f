#include "gpu/world_buffers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/contact.hpp"
#include "gpu/layout.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

gl::Buffer makeRest(const World& world) {
    std::vector<vec4> rest(world.nodeCount());
    for (int node = 0; node < world.nodeCount(); ++node)
        rest[node] = toVec4(world.restPosition(node),
                            (world.anchored(node) ? -1 : 1) * world.nodeMass(node));
    return gl::makeBuffer<vec4>(rest, GL_STATIC_DRAW, "rest positions");
}

std::vector<float> restHeights(const World& world) {
    std::vector<float> heights(world.nodeCount());
    for (int node = 0; node < world.nodeCount(); ++node)
        heights[node] = static_cast<float>(world.restPosition(node)[1]);
    return heights;
}

gl::Buffer makeCells(const World& world) {
    std::vector<glm::uvec4> cells(world.cellCount());
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        const int body = world.bodyOf(cell);
        unsigned bits =
            world.present(cell) ? static_cast<unsigned>(world.lawOf(cell)) : SUNDER_ABSENT;
        if (world.parity(cell) != 0) bits |= SUNDER_CELL_ODD;
        const IVec3 at = world.bodies()[body].coordinates(cell);
        for (int axis = 0; axis < 3; ++axis) {
            const bool low = at[axis] == 0, high = at[axis] == world.bodies()[body].cells[axis] - 1;
            bits |= (unsigned{low} | unsigned{high} << 3) << (SUNDER_CELL_SIDES_BIT + axis);
        }
        for (int corner = 0; corner < kCorners; ++corner)
            bits |= unsigned{world.anchored(kCorners * cell + corner)}
                    << (SUNDER_CELL_ANCHORS_BIT + corner);
        if (world.present(cell))
            bits |= static_cast<unsigned>(255 * world.laws()[world.lawOf(cell)].restitution + 0.5)
                    << SUNDER_CELL_RESTITUTION_BIT;
        const auto damping = static_cast<float>(
            world.present(cell) ? world.laws()[world.lawOf(cell)].contactDamping : 0);
        const auto mass = static_cast<float>(world.nodeMass(kCorners * cell));
        cells[cell] = {bits, static_cast<unsigned>(body), std::bit_cast<unsigned>(mass),
                       std::bit_cast<unsigned>(damping)};
    }
    return gl::makeBuffer<glm::uvec4>(cells, GL_STATIC_DRAW, "cells");
}

gl::Buffer makeBodies(const World& world) {
    std::vector<BodyRecord> bodies;
    for (const Body& body : world.bodies()) {
        const ContactProxy proxy = contactProxy(body.cellSize);
        bodies.push_back({toVec4(body.cells.cast<double>(), body.firstCell),
                          toVec4(body.cellSize, 0),
                          toVec4(body.gravity, std::exp(-body.drag * world.step())),
                          vec4(static_cast<float>(proxy.count.dot(IVec3(1, 16, 256))),
                               static_cast<float>(proxy.radius), 0, 0),
                          toVec4(body.axes.col(0), 0), toVec4(body.axes.col(1), 0),
                          toVec4(body.axes.col(2), 0)});
    }
    return gl::makeBuffer<BodyRecord>(bodies, GL_STATIC_DRAW, "bodies");
}

gl::Buffer makeStrengths(const World& world) {
    std::vector<vec4> strengths(world.cellCount(), vec4(0));
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (world.present(cell))
            strengths[cell].w = static_cast<float>(world.materialOf(cell).friction);
        for (int axis = 0; axis < kBondsPerCell; ++axis)
            strengths[cell][axis] = std::min(world.bondStrength(kBondsPerCell * cell + axis),
                                             static_cast<float>(SUNDER_UNBREAKABLE));
    }
    return gl::makeBuffer<vec4>(strengths, GL_STATIC_DRAW, "bond strengths");
}

gl::Buffer makeObjects(const World& world) {
    std::vector<ObjectRecord> objects(std::max<std::size_t>(1, world.objects().size()));
    for (std::size_t i = 0; i < world.objects().size(); ++i) {
        const Object& object = world.objects()[i];
        objects[i] = {
            toVec4(object.core, object.radius), toVec4(object.inverseInertia, object.inverseMass),
            toVec4({object.friction, object.restitution, std::exp(-object.drag * world.step())},
                   object.chain),
            toVec4(object.hungFrom, 0), toVec4(world.description().objects[i].colour, 0)};
    }
    return gl::makeBuffer<ObjectRecord>(objects, GL_STATIC_DRAW, "objects");
}

gl::Buffer makePartings(const World& world) {
    std::vector<PartingRecord> partings;
    for (const Parting& parting : world.partings())
        partings.push_back({toVec4(parting.low, parting.a), toVec4(parting.high, parting.b),
                            toVec4(parting.way, 0), toVec4(parting.axes.col(0), 0),
                            toVec4(parting.axes.col(1), 0), toVec4(parting.axes.col(2), 0)});
    partings.resize(std::max<std::size_t>(1, partings.size()));
    return gl::makeBuffer<PartingRecord>(partings, GL_STATIC_DRAW, "partings");
}

gl::Buffer makeLaws(const World& world) {
    std::vector<ElementLaw> laws(SUNDER_MAX_ELEMENT_LAWS);
    for (std::size_t i = 0; i < world.laws().size(); ++i) {
        const sunder::core::ElementLaw& law = world.laws()[i];
        const Material& material = world.description().materials[law.material];
        laws[i].cellSize = toVec4(law.cellSize, law.cellSize.prod());
        laws[i].elasticity = toVec4(
            {law.lambda, law.mu,
             material.law == ConstitutiveLaw::Green ? SUNDER_LAW_GREEN : SUNDER_LAW_COROTATED},
            law.stressScale);
        laws[i].fracture = toVec4({std::min(law.maxStress, double{SUNDER_UNBREAKABLE}),
                                   1 / law.damageTime, material.shearWeight},
                                  material.internalFriction);
        laws[i].extremes = toVec4({law.hotViscosity, law.largestStress,
                                   std::min(law.suddenTraction, double{SUNDER_UNBREAKABLE})},
                                  0);
    }
    return gl::makeBuffer<ElementLaw>(laws, GL_STATIC_DRAW, "materials");
}

}  // namespace

static_assert(SUNDER_MAX_ELEMENT_LAWS == kMaxElementLaws && SUNDER_NO_BOND == kNoBond);
static_assert(sizeof(BodyRecord) == 16 * SUNDER_BODY_TEXELS &&
              sizeof(EventRecord) == 16 * SUNDER_EVENT_TEXELS &&
              sizeof(ObjectRecord) == 16 * SUNDER_OBJECT_TEXELS &&
              sizeof(PartingRecord) == 16 * SUNDER_PARTING_TEXELS &&
              sizeof(ObjectMotion) == 16 * SUNDER_OBJECT_LAYERS);

gl::Defines withTurned(gl::Defines defines, bool turned) {
    if (turned) defines.push_back({"TURNED", "1"});
    return defines;
}

WorldBuffers::WorldBuffers(const World& world)
    : cellCount_(world.cellCount()),
      objectCount_(static_cast<int>(world.objects().size())),
      turned_(world.anyTurned()),
      restBuffer_(makeRest(world)),
      cellBuffer_(makeCells(world)),
      bodyBuffer_(makeBodies(world)),
      strengthBuffer_(makeStrengths(world)),
      objectBuffer_(makeObjects(world)),
      lawBuffer_(makeLaws(world)),
      partingBuffer_(makePartings(world)),
      restTexture_(gl::makeBufferTexture(restBuffer_, GL_RGBA32F, "rest positions")),
      cellTexture_(gl::makeBufferTexture(cellBuffer_, GL_RGBA32UI, "cells")),
      bodyTexture_(gl::makeBufferTexture(bodyBuffer_, GL_RGBA32F, "bodies")),
      strengthTexture_(gl::makeBufferTexture(strengthBuffer_, GL_RGBA32F, "bond strengths")),
      objectTexture_(gl::makeBufferTexture(objectBuffer_, GL_RGBA32F, "objects")),
      partingTexture_(gl::makeBufferTexture(partingBuffer_, GL_RGBA32F, "partings")) {}

NodeBuffer::NodeBuffer(const World& world)
    : restHeights_(restHeights(world)),
      buffer_(sizeof(NodeRecord) * world.nodeCount(), nullptr, GL_DYNAMIC_COPY, "nodes"),
      texture_(gl::makeBufferTexture(buffer_, GL_RGBA32F, "nodes")) {}

void NodeBuffer::write(const State& state) {
    std::vector<NodeRecord> nodes(state.displacement.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = {toVec4(state.displacement[i], restHeights_[i]), toVec4(state.velocity[i], 0)};
    buffer_.write(0, sizeof(NodeRecord) * nodes.size(), nodes.data());
}

void NodeBuffer::read(State& state) const {
    std::vector<NodeRecord> nodes(buffer_.size() / sizeof(NodeRecord));
    buffer_.read(0, buffer_.size(), nodes.data());
    state.displacement.resize(nodes.size());
    state.velocity.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto &u = nodes[i].displacement, &v = nodes[i].velocity;
        state.displacement[i] = {u.x, u.y, u.z};
        state.velocity[i] = {v.x, v.y, v.z};
    }
}

BondBuffer::BondBuffer(const World& world)
    : world_(world),
      buffer_(sizeof(BondRecord) * world.cellCount(), nullptr, GL_DYNAMIC_COPY, "bonds"),
      texture_(gl::makeBufferTexture(buffer_, GL_RGBA32F, "bonds")) {}

void BondBuffer::write(const State& state) {
    std::vector<BondRecord> bonds(state.damage.size() / kBondsPerCell);
    for (std::size_t i = 0; i < bonds.size(); ++i) {
        const double *d = &state.damage[kBondsPerCell * i], *s = &state.slow[kBondsPerCell * i];
        const double there = state.has(world_.bodyOf(static_cast<int>(i))) ? 0 : SUNDER_GONE;
        bonds[i] = {toVec4({d[0], d[1], d[2]}, there),
                    toVec4({s[0], s[1], s[2]}, state.slowStress[i])};
    }
    buffer_.write(0, sizeof(BondRecord) * bonds.size(), bonds.data());
}

void BondBuffer::read(State& state) const {
    std::vector<BondRecord> bonds(buffer_.size() / sizeof(BondRecord));
    buffer_.read(0, buffer_.size(), bonds.data());
    state.damage.resize(kBondsPerCell * bonds.size());
    state.slow.resize(kBondsPerCell * bonds.size());
    state.slowStress.resize(bonds.size());
    for (std::size_t i = 0; i < bonds.size(); ++i) {
        state.slowStress[i] = bonds[i].slow.w;
        for (int axis = 0; axis < kBondsPerCell; ++axis) {
            state.damage[kBondsPerCell * i + axis] = bonds[i].damage[axis];
            state.slow[kBondsPerCell * i + axis] = bonds[i].slow[axis];
        }
    }
}

ObjectPlaces::ObjectPlaces(const World& world) {
    const std::size_t count = world.objects().size();
    if (count == 0) return;
    buffer_ = gl::Buffer(2 * count * sizeof(vec4), nullptr, GL_DYNAMIC_COPY, "object places");
    texture_ = gl::makeBufferTexture(buffer_, GL_RGBA32F, "object places");
}

void ObjectPlaces::write(const State& state) {
    std::vector<vec4> texels;
    for (const ObjectState& object : state.objects)
        texels.push_back(toVec4(object.position, object.present ? 1 : 0));
    for (const ObjectState& object : state.objects)
        texels.push_back(toVec4(object.orientation.vec(), object.orientation.w()));
    if (!texels.empty()) buffer_.write(0, sizeof(vec4) * texels.size(), texels.data());
}

StateUpload::StateUpload(const World& world) : nodes_(world), bonds_(world), objects_(world) {}

StateView StateUpload::upload(const State& state) {
    nodes_.write(state);
    bonds_.write(state);
    objects_.write(state);
    return {&nodes_.texture(), kCorners * kNodeTexels, kNodeTexels, &bonds_.texture(),
            kBondTexels,       objects_.texture()};
}

}  // namespace sunder::gpu
