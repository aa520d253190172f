#pragma once
#include <algorithm>

#include "core/world.hpp"

/// Whether everything of a body is the same to the bit.
inline bool sameBody(const sunder::core::World& world, const sunder::core::State& a,
                     const sunder::core::State& b, int index) {
    using namespace sunder::core;
    const Body& body = world.bodies()[index];
    const auto same = [&](const auto& x, const auto& y, int each) {
        const auto first = each * body.firstCell, count = each * body.cellCount();
        return std::equal(x.begin() + first, x.begin() + first + count, y.begin() + first);
    };
    return same(a.displacement, b.displacement, kCorners) &&
           same(a.velocity, b.velocity, kCorners) && same(a.damage, b.damage, kBondsPerCell) &&
           same(a.slow, b.slow, kBondsPerCell) && same(a.slowStress, b.slowStress, 1);
}
