// Falling, pushing, sliding: motion with a closed form.
#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("free fall follows ½gt²") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        WorldDescription description = block({2, 1, 1}, softElastic());
        description.gravity = {0, -9.81, 0};
        const World world(description);
        const auto solver = under.make(world);
        // Symplectic Euler falls ½gt²·(1 + 1/n) in n steps: 12,000 steps keep that below 1e-4.
        solver->advance(12000);
        const double t = 12000 * world.step(), expected = -0.5 * 9.81 * t * t;
        const State state = solver->state();
        for (int node = 0; node < world.nodeCount(); ++node) {
            CHECK(state.displacement[node][1] == Approx(expected).epsilon(1e-4));
            CHECK(state.displacement[node][0] == 0);
        }
    }
}

TEST_CASE("drag slows as exp(−d·t), whatever the step") {
    for (const SolverUnderTest& under : solversUnderTest())
        for (const double step : {1.0 / 3000, 1.0 / 600}) {
            INFO(under.name << ", step " << step);
            Material material = softElastic();
            material.damping = 2;
            WorldDescription description = block({2, 1, 1}, material);
            description.step = step;
            const World world(description);
            const auto solver = under.make(world);
            State state = world.initialState();
            for (Vec3& v : state.velocity) v = {3, 0, 0};
            solver->setState(state);
            solver->advance(static_cast<int>(0.5 / step + 0.5));
            // One rounding of v·exp(−d·h) a step.
            CHECK(solver->state().velocity[0][0] ==
                  Approx(3 * std::exp(-1)).epsilon(1500 * under.epsilon));
        }
}

TEST_CASE("an event gives its whole impulse to a free wall") {
    using Kind = EventDescription::Kind;
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        WorldDescription description = block({7, 5, 3}, softElastic());
        EventDescription impulse;
        impulse.time = 0.0101;  // inside a step, and the end inside another
        impulse.point = {0.1, 0.3, 0.1};
        impulse.radius = 0.16;
        impulse.vector = {1, -2, 7};
        EventDescription force = impulse;
        force.kind = Kind::Force;
        force.time = 0.02;
        force.duration = 0.01;
        force.vector = {100, 0, -300};
        description.events = {impulse, force};
        const World world(description);
        const auto solver = under.make(world);
        solver->advance(30);
        CHECK(diagnose(world, solver->state()).momentum.norm() == 0);
        solver->advance(70);  // in two calls: events go on across frames
        const Vec3 expected = Vec3(1, -2, 7) + 0.01 * Vec3(100, 0, -300);
        // Event times in single precision: steps counted to 1e-5 of a step out of 15.
        CHECK((diagnose(world, solver->state()).momentum - expected).norm() <
              1e-5 * expected.norm());
    }
}

TEST_CASE("nothing goes below the ground, and friction stops a sliding block") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        Material material = softElastic();
        material.youngModulus = 1e5;
        material.damping = 5;  // or the jelly wobbles on
        WorldDescription description = block({3, 2, 2}, material);
        description.gravity = {0, -9.81, 0};
        description.ground = true;
        description.groundFriction = 0.4;
        description.bodies[0].position = {0, 0.2, 0};
        const World world(description);
        const auto solver = under.make(world);
        State state = world.initialState();
        for (Vec3& v : state.velocity) v = {2, -1, 0};
        solver->setState(state);
        double lowest = 1, travelled = 0;
        for (int i = 0; i < 80; ++i) {
            solver->advance(100);
            const State now = solver->state();
            lowest = std::min(lowest, diagnose(world, now).minY);
            travelled = now.displacement[0][0];
        }
        CHECK(lowest == 0);  // it lands, and no node is a bit lower
        CHECK(diagnose(world, solver->state()).maxSpeed < 0.01);
        // The landing takes μ·(fall speed) at once if the block does not bounce; v₀² / 2μg bounds
        // the rest of the way.
        CHECK(travelled < 0.2 + 2 * 2 / (2 * 0.4 * 9.81));
        CHECK(travelled > 0.1);
    }
}

TEST_CASE("a rigid slide on the ground stops after v²/2μg") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        // Stiff and flat, so that it neither bounces nor tips.
        Material material = softElastic();
        material.youngModulus = 1e8;
        WorldDescription description = block({4, 1, 4}, material);
        description.gravity = {0, -9.81, 0};
        description.ground = true;
        description.groundFriction = 0.3;
        const World world(description);
        const auto solver = under.make(world);
        State state = world.initialState();
        for (Vec3& v : state.velocity) v = {1, 0, 0};
        solver->setState(state);
        solver->advance(3000);
        const double expected = 1 / (2 * 0.3 * 9.81);
        // 5 %: the slab rocks a little, and its bottom nodes carry different shares of the weight.
        CHECK(solver->state().displacement[0][0] == Approx(expected).epsilon(0.05));
    }
}
