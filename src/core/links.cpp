#include "core/links.hpp"

namespace sunder::core {

std::uint8_t linkMask(unsigned held, int octant) {
    unsigned mask = 1u << octant, before = 0;
    while (mask != before) {
        before = mask;
        for (int bond = 0; bond < 12; ++bond) {
            if (!(held >> bond & 1)) continue;
            const int a = bondOctant(bond), b = a | 1 << bond / 4;
            if (mask >> a & 1 || mask >> b & 1) mask |= 1u << a | 1u << b;
        }
    }
    return static_cast<std::uint8_t>(mask);
}

std::uint8_t wholeMask(const World& world, int cell, int corner) {
    unsigned mask = 0;
    for (int octant = 0; octant < 8; ++octant)
        if (cellInOctant(world, cell, corner, octant) >= 0) mask |= 1u << octant;
    return static_cast<std::uint8_t>(mask);
}

int cellInOctant(const World& world, int cell, int corner, int octant) {
    const Body& body = world.bodies()[world.bodyOf(cell)];
    const int own = corner ^ 7;
    IVec3 c = body.coordinates(cell);
    for (int axis = 0; axis < 3; ++axis) c[axis] += (octant >> axis & 1) - (own >> axis & 1);
    return body.contains(c) ? body.cellAt(c) : -1;
}

unsigned heldBonds(const World& world, const State& state, int cell, int corner) {
    unsigned held = 0;
    for (int bond = 0; bond < 12; ++bond) {
        const int owner = cellInOctant(world, cell, corner, bondOctant(bond));
        if (owner >= 0 && state.damage[kBondsPerCell * owner + bond / 4] < 1) held |= 1u << bond;
    }
    return held;
}

}  // namespace sunder::core
