// A bar pulled slowly breaks where it is weakest, when its stress is what that place bears.
#include <algorithm>
#include <cmath>
#include <utility>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/pieces.hpp"
#include "physics/physics_worlds.hpp"
#include "physics/report.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// What the stress at a break may be off by. Pulling takes 0.8 % of the strength (kPull), drag on
/// what moves 0.5 % from end to end, damage 0.3 % (damageLength); a break waits for up to four
/// steps, 0.03 %. Twice the sum of these.
constexpr double kSlowly = 0.03;

constexpr double kYoungModulus = 6e6, kStrength = 3e4;  // Pa: breaks at a strain of half a per cent
constexpr IVec3::Scalar kLong = 24;
constexpr double kLength = 0.1 * kLong;
/// m/s, of the end that is pulled. It sends a stress of ρ·c·v ahead, a hundredth of the strength.
constexpr double kPull = 0.003;

/// ν = 0, held at both ends: one stress, E times the strain, from end to end.
WorldDescription bar(FractureMode mode) {
    WorldDescription description = elasticBlock({kLong, 2, 2}, 0.1, kYoungModulus, 0);
    description.bodies[0].anchors = {Side::Left, Side::Right};
    Material& material = description.materials[0];
    material.fracture = mode;
    material.damping = 20;
    material.maxStress = kStrength;
    material.strength = material.boundaryStrength = Vec3::Constant(kStrength);
    material.spread = 0.15;
    // From its strength on, a bond's damage takes √(2·τ·rate) of its strain more, τ = 1 mm/c: 0.3
    // %.
    material.damageLength = 1e-3;
    return description;
}

/// Pa: mean axial stress, from the strain of all cells, for ν = 0.
double meanStress(const World& world, const State& state) {
    double sum = 0;
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        const auto gradients = cellGradients(world, cell, state.displacement, 1);
        for (int t = 0; t < kTetrahedraPerCell; ++t)
            sum += (gradients[t](0, 0) - 1) * (t < 4 ? 1. / 6 : 1. / 3);
    }
    return kYoungModulus * sum / world.cellCount();
}

std::vector<int> brokenBonds(const State& state) {
    std::vector<int> broken;
    for (std::size_t bond = 0; bond < state.damage.size(); ++bond)
        if (state.damage[bond] >= 1 && state.damage[bond] != kNoBond)
            broken.push_back(static_cast<int>(bond));
    return broken;
}

struct PullTest {
    PlotPoints curve;   ///< stress, kPa, over the strain of the whole bar, 1
    double stress = 0;  ///< Pa, when the first bond broke
    std::vector<int> firstBroken;
    int pieces = 0;  ///< in the end
};

/// Starts at three quarters of `strength`, without a wave, and pulls from there.
PullTest pull(const SolverUnderTest& under, const World& world, double strength) {
    requireUnlimited(world);
    const auto solver = under.make(world);
    State state = world.initialState();
    const double strain = 0.75 * strength / kYoungModulus;
    for (int node = 0; node < world.nodeCount(); ++node)
        state.displacement[node][0] = strain * (latticePosition(world, node)[0] + kLength / 2);
    const int steps = world.fractureInterval();
    double elongation = strain * kLength;
    PullTest test;
    while (elongation < 1.3 * kLength * strength / kYoungModulus) {
        elongation += kPull * steps * world.step();
        for (int node = 0; node < world.nodeCount(); ++node)
            if (world.anchored(node) && world.restPosition(node)[0] > 0)
                state.displacement[node][0] = elongation;
        const double stress = meanStress(world, state);
        test.curve.push_back({elongation / kLength, 1e-3 * stress});
        solver->setState(state);
        solver->advance(steps);
        state = solver->state();
        if (test.firstBroken.empty()) {
            test.firstBroken = brokenBonds(state);
            test.stress = stress;
        }
    }
    test.pieces = findPieces(world, state).count;
    return test;
}

PlotPoints strengthLine(const PullTest& test, double strength) {
    return {{test.curve.front()[0], 1e-3 * strength}, {test.curve.back()[0], 1e-3 * strength}};
}

}  // namespace

TEST_CASE("a bar pulled slowly breaks at its weakest bond, at that bond's strength") {
    PhysicsReport report("strength-of-bonds", "Strength of a bar that breaks by bonds",
                         "A bar with scattered strengths is pulled at 3 mm/s; the first bond to "
                         "break must be the weakest of its strength map, at a stress that is its "
                         "strength");
    auto curves = report.plot("Pull test", {"strain of the whole bar", "1"}, {"stress", "kPa"});
    auto map =
        report.plot("Strength of the bonds along the bar", {"place", "m"}, {"strength", "kPa"});
    for (const std::uint64_t seed : {1, 2}) {
        WorldDescription description = bar(FractureMode::Bond);
        description.seed = seed;
        const World world(description);
        int weakest = 0;
        PlotPoints strengths;
        for (int cell = 0; cell < world.cellCount(); ++cell) {
            if (world.neighbour(cell, 0, +1) < 0) continue;
            const int bond = kBondsPerCell * cell;
            strengths.push_back(
                {latticePosition(world, kCorners * cell + 1)[0], 1e-3 * world.bondStrength(bond)});
            if (world.bondStrength(bond) < world.bondStrength(weakest)) weakest = bond;
        }
        const double strength = world.bondStrength(weakest);
        const std::string which = "seed " + std::to_string(seed) + ", ";
        for (const SolverUnderTest& under : allSolvers()) {
            const PullTest test = pull(under, world, strength);
            INFO(which << under.name);
            curves.series(which + under.name,
                          under.name == "cpu" ? LineStyle::Dashed : LineStyle::Line, test.curve);
            if (under.name == "cpu")
                curves.series(which + "strength of the weakest bond", LineStyle::Line,
                              strengthLine(test, strength));
            report.checkRelative("stress at the first break, " + which + under.name,
                                 1e-3 * test.stress, 1e-3 * strength, "kPa", kSlowly);
            CHECK(test.firstBroken.size() == 1);
            report.checkAbsolute(
                "number of the bond that broke first, against the weakest's, " + which + under.name,
                test.firstBroken.empty() ? -1 : test.firstBroken[0], weakest, "1", 0);
            CHECK(test.pieces > 1);
        }
        map.series("all, " + which + "four side by side", LineStyle::Points, strengths);
        map.series("the one that broke first, seed " + std::to_string(seed), LineStyle::Points,
                   {{latticePosition(world, kCorners * (weakest / kBondsPerCell) + 1)[0],
                     1e-3 * strength}});
    }
}

TEST_CASE("a bar pulled slowly breaks where a cell has the least max_stress, at that stress") {
    PhysicsReport report("strength-of-cells", "Strength of a bar that breaks by cells",
                         "A bar with one cell of a tenth less max_stress is pulled at 3 mm/s; that "
                         "cell must be the first to leave its neighbours, at a stress that is its "
                         "max_stress");
    auto curves = report.plot("Pull test", {"strain of the whole bar", "1"}, {"stress", "kPa"});
    WorldDescription description = bar(FractureMode::Cell);
    Material weak = description.materials[0];
    weak.maxStress = 0.9 * kStrength;
    description.materials.push_back(weak);
    description.bodies[0].regions = {{{15, 1, 0}, {15, 1, 0}, 1}};
    const World world(description);
    const int cell = world.bodies()[0].cellAt({15, 1, 0});
    std::vector<int> itsBonds;
    for (int axis = 0; axis < 3; ++axis) {
        if (world.neighbour(cell, axis, +1) >= 0) itsBonds.push_back(kBondsPerCell * cell + axis);
        if (const int other = world.neighbour(cell, axis, -1); other >= 0)
            itsBonds.push_back(kBondsPerCell * other + axis);
    }
    std::sort(itsBonds.begin(), itsBonds.end());
    for (const SolverUnderTest& under : allSolvers()) {
        const PullTest test = pull(under, world, weak.maxStress);
        INFO(under.name);
        curves.series(under.name, under.name == "cpu" ? LineStyle::Dashed : LineStyle::Line,
                      test.curve);
        if (under.name == "cpu")
            curves.series("max_stress of the weak cell", LineStyle::Line,
                          strengthLine(test, weak.maxStress));
        report.checkRelative("stress at the first break, " + under.name, 1e-3 * test.stress,
                             1e-3 * weak.maxStress, "kPa", kSlowly);
        CHECK(test.firstBroken == itsBonds);
        CHECK(test.pieces > 1);
    }
}

TEST_CASE("bonds under constant traction take damage at the rate that their law gives") {
    PhysicsReport report("damage-law", "Damage of bonds under constant traction",
                         "A block is held in a uniform strain; the damage of every bond against "
                         "t·c/L·(r − 1), at most 4 for r − 1, where r is traction over strength: "
                         "r² = σ² + β·(τ − μ·pressure)² over strength²");
    WorldDescription description = bar(FractureMode::Bond);
    description.bodies[0] = elasticBlock({4, 3, 3}, 0.1, kYoungModulus, 0).bodies[0];
    description.bodies[0].anchors = {Side::Left, Side::Right, Side::Bottom,
                                     Side::Top,  Side::Back,  Side::Front};
    keepAwake(description);
    Material& material = description.materials[0];
    material.spread = 0;
    material.damageLength = 5;
    material.shearWeight = 0.6;
    material.internalFriction = 0.4;
    const World world(description);
    requireUnlimited(world);
    constexpr int kUpdates = 12;
    const double time = kUpdates * description.fractureInterval * world.step();
    const double rate = std::sqrt(kYoungModulus / material.density) / material.damageLength;
    struct Case {
        const char* name;
        double xx, xy, yz;  ///< stress over strength
    };
    const Case cases[] = {{"tension", 1.25, 0, 0},
                          {"tension and shear", 1.1, 0.9, 0},
                          {"shear under pressure", -0.5, 2.2, 0},
                          {"shear of the layers", 0.8, 0, 1.9},
                          {"far too much", 7, 0, 0}};
    for (const auto& [name, xx, xy, yz] : cases) {
        // Without rotation and with ν = 0, stress is E times this strain.
        Mat3 stress = Mat3::Zero();
        stress(0, 0) = xx;
        stress(0, 1) = stress(1, 0) = xy;
        stress(1, 2) = stress(2, 1) = yz;
        const Mat3 strain = kStrength / kYoungModulus * stress;
        State state = world.initialState();
        for (int node = 0; node < world.nodeCount(); ++node)
            state.displacement[node] = strain * latticePosition(world, node);
        double expected[3];
        for (int axis = 0; axis < 3; ++axis) {
            const double normal = stress(axis, axis);
            const double shear =
                std::hypot(stress(axis, (axis + 1) % 3), stress(axis, (axis + 2) % 3));
            const double held =
                std::max(0.0, shear - material.internalFriction * std::max(0.0, -normal));
            const double ratio =
                std::hypot(std::max(0.0, normal), std::sqrt(material.shearWeight) * held);
            expected[axis] = time * rate * std::clamp(ratio - 1, 0.0, 4.0);
            REQUIRE(expected[axis] < 1);
        }
        for (const SolverUnderTest& under : allSolvers()) {
            const auto solver = under.make(world);
            solver->setState(state);
            solver->advance(kUpdates * description.fractureInterval);
            const std::vector<double> damage = solver->state().damage;
            double low[3] = {1, 1, 1}, high[3] = {0, 0, 0};
            for (std::size_t bond = 0; bond < damage.size(); ++bond) {
                if (damage[bond] == kNoBond) continue;
                low[bond % kBondsPerCell] = std::min(low[bond % kBondsPerCell], damage[bond]);
                high[bond % kBondsPerCell] = std::max(high[bond % kBondsPerCell], damage[bond]);
            }
            // F is near 1 and rounded to ε, over the strain at the strength that is 2e-5 of r in
            // single precision, and 1e-4 of r − 1. Ten times that.
            for (int axis = 0; axis < 3; ++axis)
                for (const auto& [which, found] :
                     {std::pair{"least", low[axis]}, std::pair{"most", high[axis]}})
                    report.checkAbsolute(std::string(name) + ": damage of bonds along " +
                                             "xyz"[axis] + ", " + which + ", " + under.name,
                                         found, expected[axis], "1", 1e-9 + 0.001 * expected[axis]);
        }
    }
}
