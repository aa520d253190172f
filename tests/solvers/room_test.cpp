// Walls that keep everything in (core/room.hpp).
#include "core/room.hpp"

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// m, distance from the barrier of the node that is nearest to it; negative: beyond it.
double nearest(const World& world, const State& state, const Barrier& barrier) {
    double distance = 1e9;
    for (int node = 0; node < world.nodeCount(); ++node)
        if (world.present(node / kCorners))
            distance = std::min(
                distance, barrier.distance(world.restPosition(node) + state.displacement[node]));
    return distance;
}

State moving(const World& world, const Vec3& velocity) {
    State state = world.initialState();
    for (Vec3& v : state.velocity) v = velocity;
    return state;
}

/// Rounding of places of up to 2 m in single precision, m.
constexpr double kRounding = 3e-7;

}  // namespace

TEST_CASE("a body thrown into a corner of the room stays in and comes to rest there") {
    Material material = softElastic();
    material.youngModulus = 1e5;
    material.damping = 5;
    WorldDescription d = block({3, 2, 2}, material);
    d.gravity = {4, -9.81, -3};  // leans towards the corner, or it would end where it bounces to
    d.ground = true;
    d.groundFriction = 0.1;
    d.room = RoomDescription{{-1.2, 1.1}, {-0.9, 1.3}, 0.1, 0.8};
    d.bodies[0].position = {0, 0.2, 0};
    const World world(d);
    REQUIRE(barriers(d).size() == 6);
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->setState(moving(world, {4, 3, -4}));
        for (int i = 0; i < 80; ++i) {
            solver->advance(100);
            const State now = solver->state();
            for (const Barrier& barrier : barriers(d))
                CHECK(nearest(world, now, barrier) >= -kRounding);
        }
        const State end = solver->state();
        CHECK(diagnose(world, end).maxSpeed < 0.01);
        for (const int i : {0, 2, 3})  // the floor, the walls at high x and low z
            CHECK(nearest(world, end, barriers(d)[static_cast<std::size_t>(i)]) < kRounding);
    }
}

TEST_CASE("a rigid slide along a wall or the ceiling stops after v²/2μg, as on the ground") {
    Material material = softElastic();
    material.youngModulus = 1e8;
    for (std::size_t index = 0; index < 5; ++index) {
        WorldDescription d = block({4, 4, 4}, material);
        d.room = RoomDescription{{-0.5, 0.5}, {-0.5, 0.5}, 0.3, 1};
        const Barrier barrier = barriers(d)[index];
        // A slab that lies against the barrier, its middle at [0, 0.5, 0]; the other walls far.
        if (barrier.axis != 0) d.room->x = {-9, 9};
        if (barrier.axis != 1) d.room->ceiling = 9;
        if (barrier.axis != 2) d.room->z = {-9, 9};
        BodyDescription& slab = d.bodies[0];
        slab.cells[barrier.axis] = 1;
        slab.size[barrier.axis] = 0.1;
        slab.position = {0, 0.5 - slab.size[1] / 2, 0};
        slab.position[barrier.axis] -= barrier.side * 0.45;
        d.gravity[barrier.axis] = -barrier.side * 9.81;
        const World world(d);
        const int along = (barrier.axis + 1) % 3;
        for (const SolverUnderTest& under : solversUnderTest()) {
            INFO(under.name << ", barrier " << index);
            const auto solver = under.make(world);
            Vec3 velocity = Vec3::Zero();
            velocity[along] = 1;
            solver->setState(moving(world, velocity));
            solver->advance(3000);
            // 5 %, as on the ground.
            CHECK(solver->state().displacement[0][along] ==
                  Approx(1 / (2 * 0.3 * 9.81)).epsilon(0.05));
        }
    }
}

TEST_CASE("positions agree with the reference after 100 steps against five barriers") {
    WorldDescription d = block({7, 5, 3}, softElastic());
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    // Odd numbers: what comes to a barrier at the very end of a step may be stopped in this one or
    // the next.
    d.room = RoomDescription{{-0.4037, 0.3791}, {-0.2013, 0.1722}, 0.4, 0.5519};
    const World world(d);
    for (const Vec3& velocity : {Vec3(4.1, 3.2, -5.3), Vec3(-3.3, -2.1, 4.7)}) {
        const State start = moving(world, velocity);
        cpu::ReferenceSolver reference(world);
        reference.setState(start);
        reference.advance(100);
        const State expected = reference.state();
        for (const Barrier& barrier : barriers(d))
            CHECK(nearest(world, expected, barrier) >= -kRounding);
        for (const SolverUnderTest& under : solversUnderTest()) {
            INFO(under.name);
            const auto solver = under.make(world);
            solver->setState(start);
            solver->advance(100);
            const State state = solver->state();
            double difference = 0;
            for (std::size_t i = 0; i < state.displacement.size(); ++i)
                difference =
                    std::max(difference, (state.displacement[i] - expected.displacement[i]).norm());
            CAPTURE(difference);
            CHECK(difference < 1e-4 * 0.1);  // of a cell edge
        }
    }
}

TEST_CASE("a wall that breaks in a room stays in, and joined nodes stay equal to the bit") {
    WorldDescription d = block({7, 5, 2}, brittle());
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    d.room = RoomDescription{{-0.35, 0.6}, {-0.5, 0.4}, 0.3, 0.5};
    d.events = {hit(0, {0.1, 0.2, 0.1}, {3, 2, 8})};
    const World world(d);
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto solver = under.make(world);
        for (int i = 0; i < 20; ++i) {
            solver->advance(50);
            const State now = solver->state();
            CHECK(tornNodes(world, now) == 0);
            for (const Barrier& barrier : barriers(d))
                CHECK(nearest(world, now, barrier) >= -kRounding);
        }
        CHECK(diagnose(world, solver->state()).bondsBroken > 20);
    }
}

TEST_CASE("a room that nothing reaches changes nothing") {
    WorldDescription d = block({7, 5, 3}, softElastic());
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    d.events = {hit(0, {0.1, 0.3, 0.1}, {1, -1, -6})};
    const World open(d);
    d.room = RoomDescription{};
    const World closed(d);
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto outside = under.make(open), inside = under.make(closed);
        outside->advance(200);
        inside->advance(200);
        CHECK(stateHash(inside->state()) == stateHash(outside->state()));
    }
}
