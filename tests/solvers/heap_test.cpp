// Stacks and heaps: cells in contact (core/contact.hpp) that come to rest, on the solvers that have
// it.
#include <algorithm>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/pieces.hpp"
#include "core/sleep.hpp"
#include "support/solver_under_test.hpp"
#include "support/touching_worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// m/s: what all but the fastest cells are slower than. `share`: of all cells.
double speedOfMost(const World& world, const State& state, double share) {
    std::vector<double> speeds;
    for (int cell = 0; cell < world.cellCount(); ++cell)
        speeds.push_back(meanOf(state.velocity, cell).norm());
    std::sort(speeds.begin(), speeds.end());
    return speeds[static_cast<std::size_t>(share * world.cellCount())];
}

/// Nothing is below ground or inside anything else, and something lies on something.
void checkHeap(const World& world, const State& state) {
    const Diagnostics end = diagnose(world, state);
    CAPTURE(end.maxSpeed, end.minY);
    CHECK(end.nan == 0);
    CHECK(end.minY > -0.05 * kEdge);
    const double deepest = deepestOverlap(world, state);
    CAPTURE(deepest);
    CHECK(deepest < 0.1 * kEdge);
    double highest = 0;
    for (int cell = 0; cell < world.cellCount(); ++cell)
        highest = std::max(
            highest, world.restPosition(kCorners * cell)[1] + meanOf(state.displacement, cell)[1]);
    CHECK(highest > kEdge);
}

}  // namespace

TEST_CASE("a stack of ten cells stands for ten seconds", "[long]") {
    std::vector<Vec3> places;
    for (int i = 0; i < 10; ++i) places.push_back({0, (i + 0.5) * kEdge, 0});
    Material material = cellMaterial(0.2, 0.6);
    material.damping = 1;
    WorldDescription d = singleCells(places, material);
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    const World world(d);
    for (const SolverUnderTest& under : contactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        // Friction that creeps leaves a column unstable: whatever rounding puts it aside grows
        // fortyfold a second. Sleep stops that and double precision puts it off; in single
        // precision and awake, 1e-10 m after one second are 1e-5 m after four and 0.01 m after six.
        const bool steady = under.sleeps || under.epsilon < 1e-10;
        solver->advance(steady ? 30000 : 12000);
        const State state = solver->state();
        for (int cell = 0; cell < 10; ++cell) {
            CAPTURE(cell);
            // 5 % of a cell: ten contacts give way by a thousandth each at most.
            CHECK(meanOf(state.displacement, cell).norm() < 0.05 * kEdge);
            if (under.sleeps) CHECK(solver->asleep(cell));
        }
    }
}

TEST_CASE("a broken wall falls into a heap that comes to rest", "[long]") {
    const World world(looseWall());
    const State start = looseState(world);
    const int pieces = findPieces(world, start).count;
    REQUIRE(pieces > 80);
    for (const SolverUnderTest& under : contactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->setState(start);
        solver->advance(15000);
        // When the last pieces slide and topple (kCreepSpeed says why) is chance: a start that
        // differs by a thousandth has another second for it.
        const auto moving = [&] { return speedOfMost(world, solver->state(), 0.8); };
        for (int second = 0; second < 10 && moving() >= kSleepSpeed * kEdge; ++second)
            solver->advance(3000);
        CHECK(moving() < kSleepSpeed * kEdge);
        checkHeap(world, solver->state());
        if (under.sleeps) {
            for (int second = 0; second < 20 && !solver->asleep(0); ++second) solver->advance(3000);
            CHECK(solver->asleep(0));
        }
    }
}

TEST_CASE("a thousand pieces fall into a heap that comes to rest", "[long]") {
    WorldDescription d = looseWall();
    d.bodies[0].cells = {10, 10, 10};
    d.bodies[0].size = {1, 1, 1};
    const World world(d);
    State start = world.initialState();
    breakBonds(start, 1);
    // Apart, and turned a little: a heap, not a stack.
    Random random(3);
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        const Vec3 rest = world.restPosition(kCorners * cell);
        const Vec3 moved = rest.cwiseProduct(Vec3(0.2, 0.3, 0.2)) + 0.015 * random.vector();
        const Vec3 velocity = 0.3 * random.vector();
        for (int corner = 0; corner < kCorners; ++corner) {
            start.displacement[kCorners * cell + corner] = moved + Vec3(0, 0.02, 0);
            start.velocity[kCorners * cell + corner] = velocity;
        }
    }
    REQUIRE(findPieces(world, start).count == 1000);
    for (const SolverUnderTest& under : contactSolvers()) {
        // What contact is for the reference, the heap of a hundred shows.
        if (under.name == "reference") continue;
        INFO(under.name);
        const auto solver = under.make(world);
        solver->setState(start);
        solver->advance(15000);
        // At rest as heaps are at rest; a few pieces slide down its slopes for half a minute.
        CHECK(speedOfMost(world, solver->state(), 0.95) < kCreepSpeed * kEdge);
        checkHeap(world, solver->state());
    }
}

TEST_CASE("long cells pile up and come to rest as well", "[long]") {
    WorldDescription d = looseWall();
    d.bodies[0].cells = {8, 4, 2};
    d.bodies[0].size = {0.8, 1.2, 0.2};
    const World world(d);
    for (const SolverUnderTest& under : contactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->setState(looseState(world));
        solver->advance(9000);
        const Diagnostics end = diagnose(world, solver->state());
        CAPTURE(end.maxSpeed, end.kinetic);
        CHECK(end.nan == 0);
        CHECK(end.minY > -0.05 * kEdge);
        CHECK(end.kinetic < 1);  // J, of 200 kg: a toppling piece
        CHECK(end.elastic < 5);
    }
}

TEST_CASE("a state of a heap read back and set again goes on as if nothing had happened") {
    const World world(looseWall());
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto first = under.make(world), second = under.make(world), third = under.make(world);
        first->setState(looseState(world));
        first->advance(300);
        const State middle = first->state();
        second->setState(middle);
        third->setState(middle);
        second->advance(101);
        third->advance(50);
        third->advance(51);
        CHECK(stateHash(second->state()) == stateHash(third->state()));
        // At a multiple of the search's interval, the one that went through searched there, too.
        first->advance(101);
        CHECK(stateHash(first->state()) == stateHash(second->state()));
    }
}

TEST_CASE("a sleeping cell wakes when another one hits it") {
    Material material = cellMaterial(0.2, 0.6);
    material.damping = 2;
    WorldDescription d = singleCells({{0, kEdge / 2, 0}, {0, 9, 0}}, material);
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (!under.sleeps) continue;
        INFO(under.name);
        const auto solver = under.make(world);
        // At most 4.9 m/s against the drag: the upper one needs more than 1.8 s.
        solver->advance(5400);
        CHECK(solver->asleep(0));
        bool woke = false;
        for (int i = 0; i < 60 && !woke; ++i) {
            solver->advance(60);
            woke = !solver->asleep(0);
        }
        CHECK(woke);
        CHECK(!solver->asleep(1));
        solver->advance(15000);
        CHECK(solver->asleep(0));
        CHECK(solver->asleep(1));
    }
}
