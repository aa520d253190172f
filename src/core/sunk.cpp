#include "core/sunk.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

#include "core/box_gap.hpp"
#include "core/box_pairs.hpp"
#include "core/object_contact.hpp"

namespace sunder::core {
namespace {

/// Of the sum of radii of the spheres in two cells.
constexpr double kSunkCells = 0.5;
/// Of the thinner object's thickness.
constexpr double kSunkObjects = 1.0 / 3;

/// A sphere in the middle of a cell, or an object.
struct Solid {
    RoundedBox box;
    int thing;  ///< body, or the number of bodies + object
    bool cell;
    double thickness() const { return 2 * (box.half.minCoeff() + box.radius); }
};

std::vector<Solid> solidsOf(const World& world, const State& state) {
    std::vector<Solid> solids;
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (!world.present(cell, state)) continue;
        Vec3 centre = Vec3::Zero();
        for (int node = kCorners * cell; node < kCorners * (cell + 1); ++node)
            centre += (world.restPosition(node) + state.displacement[node]) / kCorners;
        if (!centre.allFinite()) continue;
        const int body = world.bodyOf(cell);
        const double radius = world.bodies()[body].cellSize.minCoeff() / 2;
        solids.push_back({{centre, Mat3::Identity(), Vec3::Zero(), radius}, body, true});
    }
    const int bodies = static_cast<int>(world.bodies().size());
    for (std::size_t i = 0; i < state.objects.size(); ++i)
        if (state.objects[i].present)
            solids.push_back(
                {boxOf(world.objects()[i], state.objects[i]), bodies + static_cast<int>(i), false});
    return solids;
}

Box boundsOf(const RoundedBox& box) {
    const Vec3 reach = box.axes.cwiseAbs() * box.half + Vec3::Constant(box.radius);
    return {box.centre - reach, box.centre + reach};
}

/// m; 0: no more than things in touch.
double sunkDepth(const Solid& a, const Solid& b) {
    if (a.cell && b.cell) {
        const double radii = a.box.radius + b.box.radius;
        const double depth = radii - (a.box.centre - b.box.centre).norm();
        return depth > kSunkCells * radii ? depth : 0;
    }
    if (a.cell || b.cell) {
        const RoundedBox &cell = a.cell ? a.box : b.box, &object = a.cell ? b.box : a.box;
        const bool within = (cell.centre - object.nearest(cell.centre)).norm() < object.radius;
        return within ? cell.radius : 0;
    }
    const double depth = -gapBetween(a.box, b.box);
    return depth > kSunkObjects * std::min(a.thickness(), b.thickness()) ? depth : 0;
}

bool still(const World& world, int thing) {
    const int object = thing - static_cast<int>(world.bodies().size());
    return object >= 0 && world.objects()[object].inverseMass == 0;
}

std::string nameOf(const World& world, int thing) {
    const int bodies = static_cast<int>(world.bodies().size());
    return thing < bodies ? world.bodies()[thing].name
                          : world.description().objects[thing - bodies].name;
}

}  // namespace

std::vector<Sunk> sunkThings(const World& world, const State& state) {
    if (!world.description().contact) return {};
    const std::vector<Solid> solids = solidsOf(world, state);
    std::vector<Box> boxes;
    for (const Solid& solid : solids) boxes.push_back(boundsOf(solid.box));
    const int bodies = static_cast<int>(world.bodies().size());
    std::map<std::pair<int, int>, Sunk> sunk;
    forEachOverlap(boxes, [&](int i, int j) {
        const auto [a, b] = std::minmax(solids[i].thing, solids[j].thing);
        if (a == b || (b < bodies && world.parting(a, b))) return;
        if (still(world, a) && still(world, b)) return;
        const double depth = sunkDepth(solids[i], solids[j]);
        if (depth <= 0) return;
        Sunk& pair = sunk[{a, b}];
        if (depth <= pair.depth) return;
        pair = {nameOf(world, a), nameOf(world, b), depth,
                std::min(solids[i].thickness(), solids[j].thickness())};
    });
    std::vector<Sunk> all;
    for (auto& [things, pair] : sunk) all.push_back(std::move(pair));
    return all;
}

std::string sunkNote(const std::vector<Sunk>& sunk) {
    if (sunk.empty()) return {};
    const auto deepest = std::max_element(
        sunk.begin(), sunk.end(),
        [](const Sunk& x, const Sunk& y) { return x.depth / x.thinner < y.depth / y.thinner; });
    char depth[32];
    std::snprintf(depth, sizeof depth, "%.2g", deepest->depth);
    std::string note = "'" + deepest->a + "' and '" + deepest->b + "' are in each other by " +
                       depth + " m at the end";
    if (sunk.size() > 1) note += ", and so are " + std::to_string(sunk.size() - 1) + " other pairs";
    return note +
           ": contact could not carry what pressed them together; with more substeps it carries "
           "more";
}

}  // namespace sunder::core
