// What stands, hangs or spans does not break under a weight that it bears, and breaks under one
// that it does not.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "cpu/settle.hpp"
#include "scene/scene.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// The beam of the report: 4 m, 0.2 x 0.3 m, both ends anchored.
WorldDescription beam(int substeps) {
    WorldDescription d = block({40, 2, 3}, scene::loadMaterial("concrete"));
    d.bodies[0].size = {4, 0.2, 0.3};
    d.bodies[0].position = {0, 2, 0};
    d.bodies[0].anchors = {Side::Left, Side::Right};
    d.gravity = {0, -9.81, 0};
    d.step = 1.0 / (60 * substeps);
    return d;
}

/// The same, breaking as the thesis has it: by whole cells.
WorldDescription beamOfCells(int substeps) {
    WorldDescription d = beam(substeps);
    d.materials[0].fracture = FractureMode::Cell;
    d.materials[0].maxStress = 1e6;
    return d;
}

/// What stands, hangs, juts out and leans on others, of all kinds of material.
WorldDescription yard() {
    WorldDescription d;
    d.gravity = {0, -9.81, 0};
    d.step = 1.0 / 3000;
    d.contact = true;
    const auto add = [&](const char* material, Vec3 size, IVec3 cells, Vec3 position,
                         std::vector<Side> anchors) {
        BodyDescription body;
        body.name = material + std::to_string(d.bodies.size());
        body.material = static_cast<int>(d.materials.size());
        body.size = size;
        body.cells = cells;
        body.position = position;
        body.anchors = std::move(anchors);
        d.materials.push_back(scene::loadMaterial(material));
        d.bodies.push_back(body);
    };
    add("brick", {0.3, 0.6, 0.3}, {3, 6, 3}, {-0.8, 0, 0}, {});
    add("brick", {0.3, 0.6, 0.3}, {3, 6, 3}, {0.8, 0, 0}, {});
    add("concrete", {1.9, 0.2, 0.3}, {19, 2, 3}, {0, 0.6, 0}, {});
    add("wood", {0.1, 1.5, 0.1}, {1, 15, 1}, {3, 1, 0}, {Side::Top});
    add("planks", {1, 0.1, 0.2}, {10, 1, 2}, {5, 1, 0}, {Side::Left});
    add("brick", {0.8, 0.2, 0.2}, {8, 2, 2}, {7, 1, 0}, {Side::Left});
    add("glass", {1, 1, 0.05}, {10, 10, 1}, {9, 0, 0}, {Side::Bottom});
    return d;
}

/// Static stress over strength, the largest of all bonds and cells.
double loadOf(const World& world, const State& state) {
    double largest = 0;
    for (int cell = 0; cell < world.cellCount(); ++cell)
        if (world.present(cell))
            largest = std::max(largest,
                               state.slowStress[cell] / world.laws()[world.lawOf(cell)].maxStress);
    for (int bond = 0; bond < world.bondSlots(); ++bond)
        if (std::isfinite(world.bondStrength(bond)))
            largest = std::max(largest, state.slow[bond] / world.bondStrength(bond));
    return largest;
}

/// The same world with strengths at which the largest load is `load`.
WorldDescription loaded(WorldDescription d, double load) {
    const World world(d);
    const double factor = loadOf(world, cpu::settledStart(world).state) / load;
    for (Material& material : d.materials) {
        material.strength *= factor;
        material.boundaryStrength *= factor;
        material.maxStress *= factor;
    }
    return d;
}

int brokenAfter(const SolverUnderTest& under, const World& world, const State& start, int steps) {
    const auto solver = under.make(world);
    solver->setState(start);
    solver->advance(steps);
    solver->finish();
    return diagnose(world, solver->state()).bondsBroken;
}

}  // namespace

TEST_CASE("a beam that bears its weight does not break under it, at any number of substeps",
          "[long]") {
    for (const int substeps : {10, 50, 400}) {
        const World world(beam(substeps));
        const cpu::Start start = cpu::settledStart(world);
        REQUIRE(start.restless.empty());
        for (const SolverUnderTest& under : solversUnderTest()) {
            INFO(substeps << " substeps, " << under.name);
            // The first swing of a beam that is let go takes about 300 steps to its lowest point.
            CHECK(brokenAfter(under, world, start.state, 600) == 0);
        }
    }
    // Let go from its unstressed shape, it breaks: the test above can fail.
    const World world(beam(50));
    CHECK(brokenAfter(cpuSolvers().front(), world, world.initialState(), 600) > 0);
}

TEST_CASE("what stands, hangs, juts out or leans on others bears its weight", "[long]") {
    const World world(yard());
    const cpu::Start start = cpu::settledStart(world);
    REQUIRE(start.restless.empty());
    REQUIRE(loadOf(world, start.state) < 1);
    // The first swing to the lowest point takes the slowest of them, the planks, a quarter second.
    constexpr int kSteps = 800;
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        CHECK(brokenAfter(under, world, start.state, kSteps) == 0);
    }
    CHECK(brokenAfter(cpuSolvers().front(), world, world.initialState(), kSteps) > 0);
}

TEST_CASE("a beam breaks under its weight where that exceeds its strength, within a tenth",
          "[long]") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        for (const auto& [unloaded, load] : {std::pair(beam(50), 0.92),
                                             {beam(50), 1.08},
                                             {beamOfCells(50), 0.92},
                                             {beamOfCells(50), 1.08}}) {
            INFO("a load of " << load << " of what it bears");
            const World world(loaded(unloaded, load));
            const State start = cpu::settledStart(world).state;
            // 8 % too much breaks a bond in 1/(0.08 c/L) = 0.08 s, 230 steps of c = 165 m/s, L = 1
            // m.
            CHECK((brokenAfter(under, world, start, 600) > 0) == (load > 1));
        }
    }
}
