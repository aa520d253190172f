#include "support/worlds.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/links.hpp"
#include "core/strength_map.hpp"

using namespace sunder;
using namespace sunder::core;

WorldDescription block(IVec3 cells, Material material) {
    WorldDescription d;
    d.materials = {std::move(material)};
    BodyDescription body;
    body.cells = cells;
    body.size = 0.1 * cells.cast<double>();
    d.bodies = {body};
    d.gravity.setZero();
    d.ground = false;
    return d;
}

Material softElastic() {
    Material m;
    m.name = "soft";
    m.youngModulus = 1e6;
    m.damping = 0;
    m.fracture = FractureMode::None;
    return m;
}

Material brittle() {
    Material m = softElastic();
    m.fracture = FractureMode::Bond;
    m.strength = m.boundaryStrength = {2e4, 2e4, 2e4};
    m.spread = 0.3;
    m.damageLength = 0.2;
    return m;
}

EventDescription hit(int body, const Vec3& point, const Vec3& velocity) {
    EventDescription event;
    event.kind = EventDescription::Kind::Velocity;
    event.body = body;
    event.point = point;
    event.radius = 0.25;
    event.vector = velocity;
    return event;
}

double Random::operator()() {
    return 2 * hashUniform(seed_, counter_++, 0) - 1;
}
Vec3 Random::vector() {
    const double x = (*this)(), y = (*this)();
    return {x, y, (*this)()};
}
Mat3 Random::matrix() {
    Mat3 m;
    for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = (*this)();
    return m;
}
Mat3 Random::rotation() {
    return Eigen::AngleAxisd(3.14 * (*this)(), vector().normalized()).toRotationMatrix();
}

void breakBond(State& state, int cell, int axis) {
    state.damage[kBondsPerCell * cell + axis] = 1;
}

void detach(const World& world, State& state, int cell) {
    for (int axis = 0; axis < 3; ++axis) {
        if (world.neighbour(cell, axis, +1) >= 0) breakBond(state, cell, axis);
        if (const int other = world.neighbour(cell, axis, -1); other >= 0)
            breakBond(state, other, axis);
    }
}

int tornNodes(const World& world, const State& state) {
    int torn = 0;
    for (int node = 0; node < world.nodeCount(); ++node) {
        const int cell = node / kCorners, corner = node % kCorners;
        if (!world.present(cell)) continue;
        const std::uint8_t mask = linkMask(heldBonds(world, state, cell, corner), corner ^ 7);
        bool same = true;
        for (int octant = 0; octant < 8; ++octant) {
            if (!(mask >> octant & 1)) continue;
            const int other = kCorners * cellInOctant(world, cell, corner, octant) + (octant ^ 7);
            same &= state.displacement[node] == state.displacement[other] &&
                    state.velocity[node] == state.velocity[other];
        }
        torn += !same;
    }
    return torn;
}

State roundedToSingle(State state) {
    const auto round = [](Vec3& x) { x = x.cast<float>().cast<double>(); };
    for (auto* field : {&state.displacement, &state.velocity})
        for (Vec3& x : *field) round(x);
    for (ObjectState& object : state.objects) {
        round(object.position);
        round(object.velocity);
        round(object.angularMomentum);
        object.orientation = object.orientation.cast<float>().cast<double>();
    }
    for (auto* field : {&state.damage, &state.slow})
        for (double& x : *field) x = static_cast<float>(x);
    return state;
}

double largestDifference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
    return largest;
}

double momentumScale(const World& world, const State& state) {
    double sum = 0;
    for (int node = 0; node < world.nodeCount(); ++node)
        sum += world.nodeMass(node) * state.velocity[node].norm();
    for (std::size_t i = 0; i < state.objects.size(); ++i)
        if (world.objects()[i].inverseMass > 0)
            sum += state.objects[i].velocity.norm() / world.objects()[i].inverseMass;
    return sum;
}
