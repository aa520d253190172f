// What objects carry (core/object_contact.hpp: squeezed), on the solvers that have them.
#include <cmath>

#include "catch.hpp"
#include "scene/scene.hpp"
#include "support/object_worlds.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("a heavy object stands on a light one, and a tower whose masses double upward",
          "[long]") {
    WorldDescription d = objectsOnly();
    d.ground = true;
    d.gravity = {0, -9.81, 0};
    constexpr double size = 0.3;
    const auto add = [&](double mass, double x, double y) {
        d.objects.push_back(
            shaped(ObjectShape::Box, Vec3::Constant(size / 2), mass, {x, y, 0}, {0, 0, 0}));
    };
    for (int i = 0; i < 10; ++i) add(std::pow(2, i), 0, (i + 0.5) * size);
    int pairs = 0;
    for (const double ratio : {30, 1000, 10000}) {
        add(1, 1 + pairs, 0.5 * size);
        add(ratio, 1 + pairs++, 1.5 * size);
    }
    const World world(d);
    for (const SolverUnderTest& under : contactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        // Those that sleep no longer move; of the others, `reference` stands for ten seconds.
        solver->advance(under.name == "reference" ? 30000 : under.sleeps ? 3600 : 6000);
        const State state = solver->state();
        for (std::size_t i = 0; i < d.objects.size(); ++i) {
            CAPTURE(i);
            const bool onGround = i == 0 || (i >= 10 && i % 2 == 0);
            const double below = onGround ? 0 : state.objects[i - 1].position[1] + size / 2;
            // The bound is 2 % of the size.
            CHECK(below - (state.objects[i].position[1] - size / 2) < 0.02 * size);
            CHECK(std::abs(state.objects[i].position[0] - (*d.objects[i].position)[0]) < 1e-3);
            CHECK(state.objects[i].velocity.norm() < 0.01);
            if (under.sleeps) CHECK(solver->objectAsleep(static_cast<int>(i)));
        }
    }
}

TEST_CASE("what an object carried is forgotten once it is free") {
    WorldDescription d = objectsOnly();
    d.ground = true;
    d.gravity = {0, -9.81, 0};
    const Vec3 half = Vec3::Constant(0.15);
    d.objects = {shaped(ObjectShape::Box, half, 1, {0, 0.15, 0}, {0, 0, 0}),
                 shaped(ObjectShape::Box, half, 1000, {0, 0.45, 0}, {0, 0, 0}),
                 ball(0.1, 1, {0, 0.15, 0}, {0, 0, 0})};
    d.objects[2].position.reset();
    d.throws = {{0.3, 1, {20, 0.15, 0}, {0, 0, 0}, {0, 0, 0}},
                {0.8, 2, {0, 0.15, 0.6}, {0, 0, -8}, {0, 0, 0}}};
    for (ObjectDescription& object : d.objects) object.friction = 0;
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(840);
        // While it lay under it, it was as heavy.
        CHECK(solver->state().objects[0].load == Approx(1000).epsilon(0.1));
        solver->advance(2700 - 840);
        const State state = solver->state();
        // Half a second is ten times kLoadTime: what is left of the load is less than its mass, so
        // the ball drives the box before it as two of one mass do. The ground takes a little.
        const double box = state.objects[0].velocity[2], thrown = state.objects[2].velocity[2];
        CHECK(box + thrown == Approx(-8).epsilon(0.05));
        CHECK(box < -3.5);
    }
}

TEST_CASE("a ball on a chain hits a wall with its mass and no more") {
    WorldDescription d = block({6, 6, 1}, scene::loadMaterial("brick"));
    d.bodies[0].anchors = {Side::Left, Side::Right};
    d.gravity = {0, -9.81, 0};
    d.contact = true;
    // At the lowest point of its swing, a centimetre in front of the wall.
    d.objects = {ball(0.15, 100, {0, 0.3, 0.21}, {0, 0, -6})};
    d.objects[0].hungFrom = Vec3(0, 2.3, 0.21);
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        for (int i = 0; i < 40; ++i) {
            solver->advance(5);
            // The wall's friction pulls at the chain, but nothing stands on the ball.
            CHECK(solver->state().objects[0].load == 0);
        }
        // It has hit.
        CHECK(solver->state().objects[0].velocity[2] > -5);
    }
}
