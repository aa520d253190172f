// Joined copies of a lattice point move as one; what is broken stays apart.
#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/pieces.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("copies of a joined lattice point stay bit-identical for 10,000 steps", "[long]") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        Material second = brittle();
        second.density = 300;
        second.damping = 3;
        WorldDescription description = block({4, 3, 3}, brittle());
        description.materials.push_back(second);
        description.bodies[0].regions = {{{2, 0, 0}, {3, 1, 2}, 1}, {{0, 2, 2}, {0, 2, 2}, -1}};
        description.bodies[0].anchors = {Side::Bottom};
        description.gravity = {0, -9.81, 0};
        description.ground = true;
        EventDescription hit;
        hit.time = 0.2;
        hit.point = {0, 0.2, 0.15};
        hit.radius = 0.2;
        hit.vector = {1, 0.5, -60};
        description.events = {hit};
        const World world(description);
        const auto solver = under.make(world);
        for (int i = 0; i < 10; ++i) {
            solver->advance(1000);
            CHECK(tornNodes(world, solver->state()) == 0);
        }
        const Diagnostics end = diagnose(world, solver->state());
        CHECK(end.bondsBroken >
              0);  // the hit broke something, so joined groups of all shapes were tested
        CHECK(end.bondsBroken < world.bondCount());
        CHECK(end.nan == 0);
    }
}

TEST_CASE("a detached cell flies off alone") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const World world(block({3, 3, 3}, softElastic()));
        const int middle = 13;
        State state = world.initialState();
        detach(world, state, middle);
        for (int corner = 0; corner < kCorners; ++corner)
            state.velocity[kCorners * middle + corner] = {0.5, 0, 2};
        const auto solver = under.make(world);
        solver->setState(state);
        solver->advance(1500);
        const State after = solver->state();
        for (int node = 0; node < world.nodeCount(); ++node) {
            const Vec3 expected = node / kCorners == middle ? Vec3(0.25, 0, 1) : Vec3(0, 0, 0);
            CHECK((after.displacement[node] - expected).norm() <
                  2000 * under.epsilon);  // one rounding a step
        }
        CHECK(findPieces(world, after).count == 2);
    }
}

TEST_CASE("a broken bond never heals") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        WorldDescription description = block({5, 4, 2}, brittle());
        description.bodies[0].anchors = {Side::Bottom};
        EventDescription hit;
        hit.point = {0, 0.2, 0.1};
        hit.radius = 0.15;
        hit.vector = {0, 0, -40};
        EventDescription back = hit;  // pushes the pieces together again
        back.time = 0.1;
        back.vector = {0, 0, 80};
        description.events = {hit, back};
        const World world(description);
        const auto solver = under.make(world);
        State before = solver->state();
        int broken = 0;
        for (int i = 0; i < 100; ++i) {
            solver->advance(8);
            const State after = solver->state();
            for (int bond = 0; bond < world.bondSlots(); ++bond)
                REQUIRE(after.damage[bond] >= before.damage[bond]);
            before = after;
        }
        broken = diagnose(world, before).bondsBroken;
        CHECK(broken > 3);
        CHECK(broken < world.bondCount());
    }
}

TEST_CASE("an overstressed cell leaves all its neighbours, and only they") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        Material material = softElastic();
        material.fracture = FractureMode::Cell;
        material.maxStress = 5e4;
        WorldDescription description = block({5, 5, 1}, material);
        const World world(description);
        State state = world.initialState();
        // Stretch one corner of the middle cell, and its copies, outwards by a tenth of a cell:
        // only the four cells around that lattice point are strained.
        const int middle = 12;
        const Vec3 point = world.restPosition(kCorners * middle + 7);
        for (int node = 0; node < world.nodeCount(); ++node)
            if (world.restPosition(node) == point) state.displacement[node] = {0.02, 0.02, 0};
        const auto solver = under.make(world);
        solver->setState(state);
        solver->advance(1);
        const State after = solver->state();
        for (int cell = 0; cell < world.cellCount(); ++cell)
            for (int axis = 0; axis < 3; ++axis) {
                const int other = world.neighbour(cell, axis, +1);
                if (other < 0) continue;
                const bool leaves = cellPrincipalStress(world, state, cell) > material.maxStress ||
                                    cellPrincipalStress(world, state, other) > material.maxStress;
                CHECK((after.damage[kBondsPerCell * cell + axis] >= 1) == leaves);
            }
        CHECK(diagnose(world, after).bondsBroken >= 4);
        CHECK(diagnose(world, after).bondsBroken < world.bondCount());
    }
}
