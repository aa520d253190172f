#include "cpu/collisions.hpp"

#include <algorithm>
#include <limits>

#include "core/box_pairs.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();
const Box kNothing{Vec3::Constant(kNowhere), Vec3::Constant(-kNowhere)};

/// m, by which two boxes overlap; negative: how far they are apart.
double overlapOf(const Box& a, const Box& b) {
    return (a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low)).minCoeff();
}

struct CellBox {
    int cell;
    Box box;
};

/// share: of the displacements, 0 at rest.
Box cellBox(const World& world, const State& state, int cell, double share) {
    Box box = kNothing;
    for (int node = kCorners * cell; node < kCorners * (cell + 1); ++node) {
        const Vec3 x = world.restPosition(node) + share * state.displacement[node];
        box.include({x, x});
    }
    return box;
}

/// Cells of a body that reach into `where`.
std::vector<CellBox> cellsIn(const World& world, const State& state, int index, const Box& where) {
    std::vector<CellBox> cells;
    const Body& body = world.bodies()[index];
    for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
        if (!world.present(cell, state)) continue;
        const Box box = cellBox(world, state, cell, 1);
        if (box.overlaps(where)) cells.push_back({cell, box});
    }
    return cells;
}

bool collide(const World& world, const State& state, const CellBox& a, const CellBox& b,
             double depth) {
    const double overlap = overlapOf(a.box, b.box);
    if (overlap <= depth) return false;
    return overlap >
           depth + overlapOf(cellBox(world, state, a.cell, 0), cellBox(world, state, b.cell, 0));
}

}  // namespace

std::vector<std::array<int, 2>> collidingBodies(const World& world, const State& state,
                                                double depth) {
    std::vector<std::array<int, 2>> pairs;
    const Box everywhere{kNothing.high, kNothing.low};
    std::vector<Box> boxes;
    for (int body = 0; body < static_cast<int>(world.bodies().size()); ++body) {
        Box& box = boxes.emplace_back(kNothing);
        for (const CellBox& cell : cellsIn(world, state, body, everywhere)) box.include(cell.box);
    }
    forEachOverlap(boxes, [&](int a, int b) {
        const double least = depth * std::min(world.bodies()[a].cellSize.minCoeff(),
                                              world.bodies()[b].cellSize.minCoeff());
        const auto first = cellsIn(world, state, a, boxes[b]);
        const auto second = cellsIn(world, state, b, boxes[a]);
        const bool found = std::any_of(first.begin(), first.end(), [&](const CellBox& cell) {
            return std::any_of(second.begin(), second.end(), [&](const CellBox& other) {
                return collide(world, state, cell, other, least);
            });
        });
        if (found) pairs.push_back({a, b});
    });
    return pairs;
}

}  // namespace sunder::cpu
