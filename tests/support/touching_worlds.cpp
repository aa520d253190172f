#include "support/touching_worlds.hpp"

#include <algorithm>

#include "core/links.hpp"

using namespace sunder;
using namespace sunder::core;

Material cellMaterial(double restitution, double friction) {
    Material material = softElastic();
    material.restitution = restitution;
    material.friction = friction;
    return material;
}

WorldDescription singleCells(const std::vector<Vec3>& places, const Material& material) {
    WorldDescription d = block({1, 1, 1}, material);
    const BodyDescription cell = d.bodies[0];
    d.bodies.clear();
    for (const Vec3& place : places) {
        d.bodies.push_back(cell);
        d.bodies.back().position = place - Vec3(0, kEdge / 2, 0);
    }
    d.contact = true;
    return d;
}

Vec3 meanOf(const std::vector<Vec3>& field, int cell) {
    Vec3 sum = Vec3::Zero();
    for (int corner = 0; corner < kCorners; ++corner) sum += field[kCorners * cell + corner];
    return sum / kCorners;
}

void breakBonds(State& state, double share) {
    Random random(7);
    for (double& damage : state.damage)
        if (damage != kNoBond && 0.5 * (random() + 1) < share) damage = 1;
}

WorldDescription looseWall() {
    Material material = cellMaterial(0.2, 0.6);
    material.damping = 1;
    WorldDescription d = block({10, 10, 2}, material);
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    d.contact = true;
    return d;
}
State looseState(const World& world) {
    State state = world.initialState();
    breakBonds(state, 0.8);
    for (int node = 0; node < world.nodeCount(); ++node)
        state.velocity[node][2] = world.restPosition(node)[1] > 0.5 ? 1.5 : 0;
    return state;
}

double deepestOverlap(const World& world, const State& state) {
    std::vector<Vec3> centres;
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        Vec3 rest = Vec3::Zero();
        for (int corner = 0; corner < kCorners; ++corner)
            rest += world.restPosition(kCorners * cell + corner) / kCorners;
        centres.push_back(rest + meanOf(state.displacement, cell));
    }
    const auto joined = [&](int a, int b) {
        for (int corner = 0; corner < kCorners; ++corner) {
            const std::uint8_t mask = linkMask(heldBonds(world, state, a, corner), corner ^ 7);
            for (int octant = 0; octant < 8; ++octant)
                if (mask >> octant & 1 && cellInOctant(world, a, corner, octant) == b) return true;
        }
        return false;
    };
    double deepest = 0;
    for (int a = 0; a < world.cellCount(); ++a)
        for (int b = a + 1; b < world.cellCount(); ++b)
            if (const double overlap = kEdge - (centres[a] - centres[b]).norm(); overlap > deepest)
                if (!joined(a, b)) deepest = overlap;
    return deepest;
}
