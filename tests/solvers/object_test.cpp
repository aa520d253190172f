// Objects (core/object_contact.hpp), on the solvers that have them.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/object_contact.hpp"
#include "cpu/reference.hpp"
#include "scene/scene.hpp"
#include "support/object_worlds.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {}  // namespace

TEST_CASE("a ball bounces off the ground with its restitution") {
    for (const SolverUnderTest& under : touchingSolvers())
        for (const double restitution : {0.0, 0.5, 0.9}) {
            INFO(under.name << ", e " << restitution);
            WorldDescription d = objectsOnly();
            d.ground = true;
            d.objects = {ball(0.1, 3, {0, 0.5, 0}, {0, -4, 0})};
            d.objects[0].restitution = restitution;
            const World world(d);
            const auto solver = under.make(world);
            solver->advance(450);
            const ObjectState after = solver->state().objects[0];
            CHECK(after.velocity[1] == Approx(4 * restitution).margin(1e-5));
            // It turned back before the surface by less than what it moves in a step.
            const double lost = 4. / 3000;
            CHECK(after.position[1] > 0.1 - 1e-6);
            CHECK(after.position[1] ==
                  Approx(0.1 + 4 * restitution * (0.15 - 0.1)).margin(2 * lost));
        }
}

TEST_CASE("two balls part with the mean of their restitutions, momentum kept") {
    for (const SolverUnderTest& under : touchingSolvers())
        for (const double offset : {0.0, 0.08}) {
            INFO(under.name << ", offset " << offset);
            WorldDescription d = objectsOnly();
            d.objects = {ball(0.1, 3, {-0.2, 0, 0}, {2, 0, 0}),
                         ball(0.05, 1, {0.2, offset, 0}, {-1, 0, 0})};
            d.objects[0].restitution = 0.4;
            d.objects[1].restitution = 0.8;
            d.objects[0].friction = d.objects[1].friction = 0;
            const World world(d);
            const auto solver = under.make(world);
            const Diagnostics before = diagnose(world, solver->state());
            solver->advance(400);
            const State state = solver->state();
            const Diagnostics after = diagnose(world, state);
            CHECK((after.momentum - before.momentum).norm() < 100 * 7 * under.epsilon);
            CHECK(after.kinetic < before.kinetic);
            // The normal where they touch first, up to the way of one step.
            const double y = offset / 0.15, x = std::sqrt(1 - y * y);
            const Vec3 parting = state.objects[1].velocity - state.objects[0].velocity;
            CHECK(parting.dot(Vec3(x, y, 0)) == Approx(0.6 * 3 * x).epsilon(0.03));
        }
}

TEST_CASE("a room's walls and fixed obstacles throw a ball back") {
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        WorldDescription d = objectsOnly();
        d.room = RoomDescription{{-1, 1}, {-2, 200}, 0.5, 3.0};
        d.objects = {ball(0.1, 3, {0, 1, 0}, {6, 0, 0}), ball(0.1, 3, {0, 2, 1}, {0, 4, 0}),
                     ball(0.1, 3, {0.5, 1, 3}, {0, 0, 5}),
                     shaped(ObjectShape::Box, {1, 0.5, 0.25}, 1, {0, 1, 4}, {0, 0, 0})};
        for (ObjectDescription& object : d.objects) object.restitution = 0.5;
        d.objects[3].fixed = true;
        const World world(d);
        const auto solver = under.make(world);
        solver->advance(900);
        const State state = solver->state();
        // Off the wall at x = 1 once, off the ceiling, off the box.
        CHECK((state.objects[0].velocity - Vec3(-3, 0, 0)).norm() < 1e-4);
        CHECK((state.objects[1].velocity - Vec3(0, -2, 0)).norm() < 1e-4);
        CHECK((state.objects[2].velocity - Vec3(0, 0, -2.5)).norm() < 1e-4);
        CHECK(state.objects[3].position == Vec3(0, 1, 4));
        CHECK(state.objects[3].velocity.isZero());
    }
}

TEST_CASE("a box that is set down stands, one on another, and a ball rolls") {
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        WorldDescription d = objectsOnly();
        d.ground = true;
        d.gravity = {0, -9.81, 0};
        d.objects = {shaped(ObjectShape::Box, {0.2, 0.1, 0.3}, 10, {0, 0.1, 0}, {0, 0, 0}),
                     shaped(ObjectShape::Box, {0.1, 0.1, 0.1}, 4, {0.02, 0.3, 0}, {0, 0, 0}),
                     ball(0.1, 2, {2, 0.1, 0}, {1, 0, 0})};
        d.objects[2].friction = 1;
        const World world(d);
        const auto solver = under.make(world);
        solver->advance(3000);
        const State state = solver->state();
        for (int i = 0; i < 2; ++i) {
            CAPTURE(i);
            // A weight W gives way by W·h·τ/M: less than a millimetre here.
            CHECK((state.objects[i].position - *d.objects[i].position).norm() < 2e-3);
            CHECK(state.objects[i].velocity.norm() < 0.01);
            CHECK(state.objects[i].orientation.w() > 0.9999);
        }
        // Sliding becomes rolling, which keeps 5/7 of the speed.
        const ObjectState& rolling = state.objects[2];
        CHECK(rolling.velocity[0] == Approx(5. / 7).epsilon(0.03));
        CHECK(rolling.spin(world.objects()[2])[2] ==
              Approx(-rolling.velocity[0] / 0.1).epsilon(0.03));
    }
}

TEST_CASE("a ball on a chain swings as a pendulum does") {
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        WorldDescription d = objectsOnly();
        d.gravity = {0, -9.81, 0};
        d.objects = {ball(0.1, 20, {2 * std::sin(0.2), 3 - 2 * std::cos(0.2), 0}, {0, 0, 0})};
        d.objects[0].hungFrom = Vec3(0, 3, 0);
        const World world(d);
        const auto solver = under.make(world);
        // Half a period, with the first correction for the swing's width.
        const double half = 3.14159265 * std::sqrt(2 / 9.81) * (1 + 0.04 / 16);
        solver->advance(static_cast<int>(std::lround(half * 3000)));
        const ObjectState after = solver->state().objects[0];
        CHECK(after.position[0] == Approx(-2 * std::sin(0.2)).epsilon(0.01));
        CHECK((after.position - Vec3(0, 3, 0)).norm() == Approx(2).epsilon(1e-4));
    }
}

TEST_CASE("a free spin keeps its angular momentum and its energy", "[long]") {
    WorldDescription d = objectsOnly();
    const auto add = [&](const Vec3& size, const Vec3& spin) {
        const double z = 3.0 * static_cast<double>(d.objects.size());
        d.objects.push_back(shaped(ObjectShape::Box, size / 2, 5, {0, 0, z}, {0, 0, 0}));
        d.objects.back().spin = spin;
    };
    add({1, 0.2, 0.02}, {150, 150, 150});  // a plank
    add({1, 0.01, 0.01}, {400, 1, 1});     // thin rods
    add({1, 0.02, 0.01}, {577, 577, 577});
    add({0.3, 0.2, 0.1}, {10, 1000, 10});  // about its unstable axis
    add({0.6, 0.2, 0.4}, {0.1, 8, 6});
    const World world(d);
    for (const SolverUnderTest& under : contactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        // A minute, which software drivers take minutes for; where rounding drifts, in single
        // precision, energy is put back at every step, so that a second shows as much.
        const bool onCpu = under.name == "cpu" || under.name == "reference";
        const int steps = onCpu ? 180000 : 3000;
        // In double precision the split's own error, which does not grow: turnedFreely().
        const double error = onCpu ? 4e-4 : 1e-5;
        const State before = solver->state();
        solver->advance(steps);
        const State after = solver->state();
        for (std::size_t i = 0; i < d.objects.size(); ++i) {
            CAPTURE(i);
            const Object& object = world.objects()[i];
            CHECK(after.objects[i].angularMomentum == before.objects[i].angularMomentum);
            CHECK(after.objects[i].kineticEnergy(object) ==
                  Approx(before.objects[i].kineticEnergy(object)).epsilon(error));
        }
    }
}

TEST_CASE("every solver's objects push as the reference's") {
    WorldDescription d = block({6, 6, 2}, softElastic());
    d.materials[0].restitution = 0.4;
    d.ground = true;
    d.contact = true;
    d.objects = {ball(0.15, 20, {0.05, 0.3, 0.245}, {0.5, -1, -7}),
                 shaped(ObjectShape::Box, {0.2, 0.1, 0.1}, 12, {0.1, 0.701, 0}, {0, -6, 1}),
                 shaped(ObjectShape::Capsule, {0.08, 0.25, 0.08}, 6, {-0.375, 0.3, 0}, {5, 1, 0})};
    d.objects[0].spin = {20, 10, -5};
    d.objects[1].spin = {3, 2, -9};
    d.objects[2].orientation = Eigen::AngleAxisd(0.3, Vec3(1, 2, 2) / 3);
    for (ObjectDescription& object : d.objects) object.mayOverlap = true;  // by 5 mm
    const World world(d);
    cpu::ReferenceSolver reference(world);
    for (int snapshot = 0; snapshot < 4; ++snapshot) {
        const State before = roundedToSingle(reference.state());
        cpu::ReferenceSolver expected(world);
        expected.setState(before);
        expected.advance(1);
        const State after = expected.state();
        // They do touch.
        for (int i = 0; i < 3; ++i)
            if (snapshot == 0)
                CHECK((after.objects[i].velocity - before.objects[i].velocity).norm() > 0.05);
        for (const SolverUnderTest& under : touchingSolvers()) {
            INFO(under.name << ", snapshot " << snapshot);
            const auto solver = under.make(world);
            solver->setState(before);
            solver->advance(1);
            const State state = solver->state();
            const double worst = largestDifference(state.velocity, after.velocity);
            CAPTURE(worst);
            // A place of 1 m is known to ε; a gap that much wrong is 1/h of it in speed, a few
            // places and touches together; elements add as much.
            const double bound = 40 * 6e-8 / world.step();
            CHECK(worst < bound);
            for (int i = 0; i < 3; ++i) {
                CAPTURE(i);
                CHECK((state.objects[i].velocity - after.objects[i].velocity).norm() < bound);
                CHECK((state.objects[i].spin(world.objects()[i]) -
                       after.objects[i].spin(world.objects()[i]))
                          .norm() < bound / 0.05);  // lever arms of 5 cm and more
            }
        }
        reference.advance(23);
    }
}

TEST_CASE("a ball of 50 kg gives a free wall what it loses", "[long]") {
    for (const char* material :
         {"concrete", "brick", "wood", "planks", "glass", "rubber", "wood-thesis", "rubber-thesis"})
        for (const double speed : {5.0, 15.0, 40.0}) {
            WorldDescription d = block({12, 8, 1}, scene::loadMaterial(material));
            d.contact = true;
            d.objects = {ball(0.18, 50, {0.05, 0.42, 0.25}, {0, 0, -speed})};
            d.materials[0].damping = 0;
            d.objects[0].friction = 0.3;
            const World world(d);
            for (const SolverUnderTest& under : contactSolvers()) {
                INFO(under.name << ", " << material << ", " << speed << " m/s");
                const auto solver = under.make(world);
                const Diagnostics before = diagnose(world, solver->state());
                double most = 0;
                for (int i = 0; i < 10; ++i) {
                    solver->advance(30);
                    const State state = solver->state();
                    const Diagnostics now = diagnose(world, state);
                    REQUIRE(now.nan == 0);
                    CHECK((now.momentum - before.momentum).norm() < 1e-3 * 50 * speed);
                    most = std::max(most, now.kinetic + now.elastic);
                }
                CHECK(most <= before.kinetic * (1 + 1e-3));
                const State state = solver->state();
                CHECK(state.objects[0].velocity[2] > -speed);
                if (state.objects[0].position[2] < -0.05) {
                    // It went through: what was in the way is broken.
                    CHECK(diagnose(world, state).bondsBroken > 0);
                }
            }
        }
}

TEST_CASE("whatever an object is and does, no number is lost") {
    struct Case {
        const char* what;
        ObjectDescription object;
    };
    const Case cases[] = {
        {"200 m/s", ball(0.18, 50, {0.05, 0.42, 0.4}, {0, 0, -200})},
        {"a gram", ball(0.02, 1e-3, {0.05, 0.42, 0.2}, {0, 0, -200})},
        {"a hundred tons", ball(1, 1e5, {0, 0.4, 1.2}, {0, 0, -20})},
        {"inside", ball(0.2, 50, {0.05, 0.42, 0}, {0, 0, 0})},
        {"a needle",
         shaped(ObjectShape::Capsule, {0.005, 0.5, 0.005}, 1, {0, 0.4, 0.6}, {0, 0, -50})},
        {"a spinning plate",
         shaped(ObjectShape::Box, {0.5, 0.02, 0.5}, 5, {0, 0.4, 0.6}, {0, 0, -10})},
    };
    for (const Case& c : cases) {
        WorldDescription d = block({12, 8, 1}, brittle());
        d.contact = true;
        d.ground = true;
        d.gravity = {0, -9.81, 0};
        d.objects = {c.object};
        d.objects[0].spin = {100, 300, 1000};
        d.objects[0].mayOverlap = true;
        const World world(d);
        for (const SolverUnderTest& under : touchingSolvers()) {
            INFO(under.name << ", " << c.what);
            const auto solver = under.make(world);
            solver->advance(400);
            const Diagnostics end = diagnose(world, solver->state());
            CHECK(end.nan == 0);
            CHECK(end.maxSpeed < 250);
        }
    }
}

TEST_CASE("nothing small and fast slips through a wall") {
    WorldDescription d = block({8, 8, 1}, softElastic());
    d.materials[0].youngModulus = 1e8;
    d.bodies[0].anchors = {Side::Bottom, Side::Top, Side::Left, Side::Right};
    d.contact = true;
    // Where four cells meet, and at a face's middle.
    for (const Vec3& place : {Vec3(0, 0.4, 0.5), Vec3(0.05, 0.45, 0.5)})
        for (const double speed : {30.0, 200.0, 1000.0}) {
            d.objects = {ball(0.01, 0.01, place, {0, 0, -speed})};
            const World world(d);
            for (const SolverUnderTest& under : touchingSolvers()) {
                INFO(under.name << ", " << speed << " m/s");
                const auto solver = under.make(world);
                solver->advance(static_cast<int>(1.5 / speed * 3000) + 30);
                const ObjectState after = solver->state().objects[0];
                CHECK(after.position[2] > 0.04);
                CHECK(after.velocity[2] > -1);
            }
        }
}

TEST_CASE("a sleeping wall wakes for a ball before it is hit") {
    Material material = softElastic();
    material.damping = 2;
    WorldDescription d = block({6, 6, 1}, material);
    d.contact = true;
    d.objects = {ball(0.1, 5, {0, 0, 0}, {0, 0, 0})};
    d.objects[0].position.reset();
    d.throws = {{1.0, 0, {0, 0.3, 3}, {0, 0, -20}, {0, 0, 0}}};
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (!under.sleeps) continue;
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(2900);
        CHECK(solver->asleep(0));
        CHECK(!solver->state().objects[0].present);
        // 2.85 m of way at 20 m/s, then 0.3 s.
        solver->advance(100 + 430 + 900);
        CHECK(!solver->asleep(0));
        const State state = solver->state();
        const Diagnostics now = diagnose(world, state);
        CHECK(now.momentum[2] == Approx(-100).epsilon(0.5));  // damped
        CHECK(state.objects[0].velocity[2] > -19);
        CHECK(state.velocity[0][2] < -0.5);
    }
}

TEST_CASE("objects repeat themselves to the bit") {
    WorldDescription d = block({6, 6, 2}, brittle());
    d.contact = true;
    d.ground = true;
    d.gravity = {0, -9.81, 0};
    d.objects = {ball(0.15, 20, {0.05, 0.3, 0.4}, {0.5, -1, -7}),
                 shaped(ObjectShape::Box, {0.2, 0.1, 0.1}, 12, {0.1, 0.9, 0}, {0, -6, 1})};
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (under.name == "auto") continue;  // who advances what depends on the clock
        INFO(under.name);
        const auto first = under.make(world), second = under.make(world);
        first->advance(600);
        for (int i = 0; i < 6; ++i) second->advance(100);
        CHECK(stateHash(first->state()) == stateHash(second->state()));
        CHECK(momentumScale(world, first->state()) > 1);
    }
}
