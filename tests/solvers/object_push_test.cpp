// Blasts push objects (src/cpu/object_push.hpp), on the solvers that have them.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/saved_state.hpp"
#include "cpu/reference.hpp"
#include "support/object_worlds.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Of every body. duration: in steps.
EventDescription blast(const WorldDescription& d, const Vec3& point, double radius,
                       double duration) {
    EventDescription event;
    event.kind = EventDescription::Kind::Velocity;
    event.body = kEveryBody;
    event.point = point;
    event.radius = radius;
    event.duration = duration * d.step;
    return event;
}

/// m/s or kg·m²/s, whichever is more.
double motionDifference(const ObjectState& a, const ObjectState& b) {
    return std::max((a.velocity - b.velocity).norm(),
                    (a.angularMomentum - b.angularMomentum).norm());
}

}  // namespace

TEST_CASE("a free object in a blast becomes faster by what the push says") {
    WorldDescription d = objectsOnly();
    d.objects = {ball(0.1, 3, {0.5, 1, 0}, {1, 0, 0}),
                 shaped(ObjectShape::Box, {0.2, 0.1, 0.3}, 7, {-0.5, 1.3, 0.2}, {0, 0, 0}),
                 shaped(ObjectShape::Capsule, {0.1, 0.3, 0.1}, 2, {0, 0.4, -0.3}, {0, -2, 0}),
                 ball(0.1, 3, {9, 1, 0}, {1, 0, 0})};
    // A share of e^−1 of its motion is left after the 15 steps.
    d.objects[2].drag = 200;
    const World world(d);
    EventDescription push = blast(d, {0, 1, 0}, 3, 14.5);
    push.time = 3.25 * d.step;
    push.vector = {2, 5, -1};
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->push(world.makeEvent(push));
        solver->advance(3);
        CHECK(solver->state().objects[0].velocity == Vec3(1, 0, 0));
        solver->advance(17);
        const State state = solver->state();
        // 15 sums of up to 6 m/s, or 7 kg · 6 m/s · 0.4 m, each of eight parts that are rounded.
        const double bound = 15 * 8 * 17 * under.epsilon;
        for (int i = 0; i < 2; ++i) {
            CAPTURE(i);
            CHECK((state.objects[i].velocity - d.objects[i].velocity - push.vector).norm() < bound);
            CHECK(state.objects[i].angularMomentum.norm() < bound);
        }
        // Step k of 3 … 17 gives its share, which fades from the next one on.
        const double kept = std::exp(-200 * d.step);
        Vec3 expected(0, -2, 0);
        const Event event = world.makeEvent(push);
        for (int step = 0; step < 20; ++step)
            expected = kept * expected + event.weight(step) / 14.5 * push.vector;
        CHECK((state.objects[2].velocity - expected).norm() < bound);
        CHECK(state.objects[3].velocity == Vec3(1, 0, 0));  // out of reach
    }
}

TEST_CASE("a blast pushes an object outward, less towards the rim") {
    WorldDescription d = objectsOnly();
    const Vec3 centre(0.3, 1, -0.2), way = Vec3(1, 2, -2) / 3;
    constexpr double kRadius = 1e-3, kDistances[] = {0.4, 0.9, 1.3};
    for (const double distance : kDistances)
        d.objects.push_back(ball(kRadius, 0.01, centre + distance * way, {0, 0, 0}));
    const World world(d);
    EventDescription push = blast(d, centre, 1.2, 1);
    push.outward = 4;
    for (const bool falloff : {false, true})
        for (const SolverUnderTest& under : touchingSolvers()) {
            INFO(under.name << ", falloff " << falloff);
            push.falloff = falloff;
            const auto solver = under.make(world);
            solver->push(world.makeEvent(push));
            solver->advance(1);
            const State state = solver->state();
            for (int i = 0; i < 3; ++i) {
                CAPTURE(i);
                const double distance = kDistances[i];
                double speed = distance < 1.2 ? 4 : 0;
                if (falloff) speed *= 1 - distance * distance / 1.44;
                // Over a small ball the mean of the push differs from that at its centre by its
                // second derivatives, up to 1/distance² or 1/1.44, times radius²; places near 1 m
                // are known to 1e-7 m.
                const double bound =
                    4 * (2 * kRadius * kRadius / (distance * distance) + 1e-6 / distance);
                CHECK((state.objects[i].velocity - speed * way).norm() < bound);
            }
        }
}

TEST_CASE("a blast beside its middle spins a box as its torque says") {
    WorldDescription d = objectsOnly();
    const Vec3 half(0.3, 0.2, 0.1), place(0.4, 1, -0.3);
    d.objects = {shaped(ObjectShape::Box, half, 5, place, {0, 0, 0})};
    d.objects[0].orientation = Eigen::AngleAxisd(0.7, Vec3(1, -2, 2) / 3);
    const World world(d);
    EventDescription push = blast(d, place + Vec3(0.1, -0.4, 0.3), 2, 1);
    push.vector = {3, 1, -2};
    push.falloff = true;
    // a(x) = (1 − |x − c|²/R²)·v in the whole box, a polynomial of second degree; so the mean is
    // exact, and the torque's, of third. With the box's second moments S and d = c − place:
    // mean = (1 − (tr S + |d|²)/R²)·v, torque/m = mean of x × a = 2/R²·(S·d) × v.
    const Mat3 axes = d.objects[0].orientation.toRotationMatrix();
    const Mat3 second = axes * Vec3(half.cwiseAbs2() / 3).asDiagonal() * axes.transpose();
    const Vec3 offset = push.point - place;
    const Vec3 velocity = (1 - (second.trace() + offset.squaredNorm()) / 4) * push.vector;
    const Vec3 momentum = 5 * 2. / 4 * (second * offset).cross(push.vector);
    REQUIRE(momentum.norm() > 0.04);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->push(world.makeEvent(push));
        solver->advance(1);
        const ObjectState after = solver->state().objects[0];
        // The ball's place is in single precision for all of them; some ten operations on numbers
        // of up to 4 m/s, or 5 kg · 4 m/s · 0.4 m.
        CHECK((after.velocity - velocity).norm() < 10 * 4 * 6e-8);
        CHECK((after.angularMomentum - momentum).norm() < 10 * 8 * 6e-8);
        // And it goes on turning so.
        solver->advance(300);
        const ObjectState later = solver->state().objects[0];
        CHECK(later.angularMomentum == after.angularMomentum);
        CHECK(later.kineticEnergy(world.objects()[0]) ==
              Approx(after.kineticEnergy(world.objects()[0])).epsilon(1e-5));
    }
}

TEST_CASE("every solver's objects are blasted as the reference's") {
    WorldDescription d = objectsOnly();
    d.gravity = {0, -9.81, 0};
    d.objects = {ball(0.15, 20, {0.2, 1.3, 0.1}, {0.5, -1, -7}),
                 shaped(ObjectShape::Box, {0.2, 0.1, 0.1}, 12, {-0.4, 0.7, 0}, {0, -6, 1}),
                 shaped(ObjectShape::Capsule, {0.08, 0.25, 0.08}, 6, {0, 0.4, -0.6}, {5, 1, 0}),
                 ball(0.1, 1, {1, 1, 0}, {0, 0, 0})};
    d.objects[1].spin = {3, 2, -9};
    d.objects[1].drag = 3;
    d.objects[2].orientation = Eigen::AngleAxisd(0.3, Vec3(1, 2, 2) / 3);
    d.objects[3].hungFrom = Vec3(1, 2.5, 0);
    d.events = {blast(d, {0, 0.9, 0}, 1, 30), blast(d, {0.1, 0, -0.2}, 0.9, 30)};
    d.events[0].outward = 8;
    d.events[0].falloff = true;
    d.events[1].vector = {2, 9, 1};
    const World world(d);
    cpu::ReferenceSolver reference(world);
    for (int snapshot = 0; snapshot < 4; ++snapshot) {
        const State before = roundedToSingle(reference.state());
        cpu::ReferenceSolver expected(world);
        expected.setState(before);
        expected.advance(1);
        const State after = expected.state();
        for (const SolverUnderTest& under : touchingSolvers()) {
            INFO(under.name << ", snapshot " << snapshot);
            const auto solver = under.make(world);
            solver->setState(before);
            solver->advance(1);
            const State state = solver->state();
            // Some ten operations on speeds of up to 10 m/s and momenta of as many kg·m²/s; a chain
            // holds what it does by a place that is known to 1e-7 m, over a step.
            for (int i = 0; i < 4; ++i) {
                CAPTURE(i);
                CHECK(motionDifference(state.objects[i], after.objects[i]) <
                      100 * 6e-8 + (i == 3 ? 2e-7 / d.step : 0));
            }
        }
        // Within the blasts, and not the same without them.
        WorldDescription calm = d;
        calm.events.clear();
        const World still(calm);
        cpu::ReferenceSolver without(still);
        without.setState(before);
        without.advance(1);
        for (int i = 0; i < 4; ++i)
            CHECK(motionDifference(without.state().objects[i], after.objects[i]) > 1e-3);
        reference.advance(7);
    }
}

TEST_CASE("a blast moves nothing that is fixed, kinematic or not there") {
    WorldDescription d = objectsOnly();
    for (int i = 0; i < 3; ++i) d.objects.push_back(ball(0.1, 3, {0.5 * i, 1, 0}, {0, 0, 0}));
    d.objects[0].fixed = true;
    d.objects[1].kinematic = true;
    d.objects[1].velocity = {0, 0, 1};
    d.objects[2].position.reset();
    const World world(d);
    EventDescription push = blast(d, {0.5, 1, 0.1}, 3, 20);
    push.vector = {0, 9, 0};
    push.outward = 9;
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world), calm = under.make(world);
        solver->push(world.makeEvent(push));
        solver->advance(30);
        calm->advance(30);
        CHECK(solver->state().objects == calm->state().objects);
    }
}

TEST_CASE("a blast wakes the objects in its reach, and what sleeps with them") {
    WorldDescription d = objectsOnly();
    d.step = 1.0 / 600;
    d.materials[0].youngModulus = 1e5;  // as the step allows
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    // A crate on another, and one elsewhere.
    for (const Vec3& place : {Vec3(0, 0.1, 0), Vec3(0, 0.3, 0), Vec3(3, 0.1, 0)})
        d.objects.push_back(shaped(ObjectShape::Box, {0.1, 0.1, 0.1}, 4, place, {0, 0, 0}));
    const World world(d);
    EventDescription push = blast(d, {0, 0.5, 0}, 0.3, 3);  // it pushes the upper one alone
    push.time = 0.5 * d.step;
    push.vector = {0, 1, 0};
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (!under.sleeps) continue;
        INFO(under.name);
        const auto solver = under.make(world);
        for (int i = 0; i < 20 && !solver->objectAsleep(1); ++i) solver->advance(60);
        for (int i = 0; i < 3; ++i) REQUIRE(solver->objectAsleep(i));
        const State asleep = solver->state();
        EventDescription late = push;
        late.time = 10.5 * d.step;
        solver->push(world.makeEvent(late, static_cast<double>(asleep.step) * d.step));
        solver->advance(8);
        CHECK(solver->objectAsleep(1));
        solver->advance(8);
        CHECK(!solver->objectAsleep(0));
        CHECK(!solver->objectAsleep(1));
        CHECK(solver->objectAsleep(2));
        const State awake = solver->state();
        // 5.5 of 16 steps of falling are left after the rise; a step's share may be lost to touch.
        CHECK(awake.objects[1].velocity[1] == Approx(1 - 9.81 * 5.5 * d.step).margin(0.06));
        CHECK(awake.objects[2] == asleep.objects[2]);
        // They come to rest again.
        for (int i = 0; i < 20 && !solver->objectAsleep(1); ++i) solver->advance(60);
        CHECK(solver->objectAsleep(1));
        // A push too weak to move it keeps it awake as long as it acts, 1.5 s.
        EventDescription weak = blast(d, {0, 0.5, 0}, 0.3, 900);
        weak.vector = {0.1, 0, 0};
        solver->push(world.makeEvent(weak, static_cast<double>(solver->state().step) * d.step));
        int sleeping = 0;  // steps
        for (int i = 0; i < 880; ++i) {
            solver->advance(1);
            sleeping += solver->objectAsleep(1);
        }
        CHECK(sleeping == 0);
        CHECK((solver->state().objects[1].position - awake.objects[0].position).norm() < 0.3);
        solver->advance(600);
        CHECK(solver->objectAsleep(1));
    }
}

TEST_CASE(
    "what is pushed while time runs is pushed as by the same event of the world, to the bit") {
    WorldDescription d = block({5, 5, 1}, brittle());
    d.bodies[0].anchors = {Side::Bottom};
    d.ground = d.contact = true;
    d.gravity = {0, -9.81, 0};
    d.objects = {ball(0.1, 20, {0.2, 0.3, 0.4}, {0, 0, -3}),
                 shaped(ObjectShape::Box, {0.1, 0.1, 0.1}, 4, {0, 0.1, 0.6}, {0, 0, 0})};
    const World plain(d);
    EventDescription push = blast(d, {0.1, 0.1, 0.8}, 0.9, 15);
    push.time = 8.3 * d.step;
    push.outward = 40;
    push.falloff = true;
    d.events = {push};
    const World planned(d);
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto expected = under.make(planned), late = under.make(plain),
                   restored = under.make(plain);
        expected->advance(8);
        late->advance(8);
        late->push(plain.makeEvent(push));
        expected->advance(9);
        for (int i = 0; i < 9; ++i) late->advance(1);
        CHECK(stateHash(late->state()) == stateHash(expected->state()));
        // In the midst of the blast.
        restoreState(plain, *restored, saveState(plain, *late));
        for (Solver* solver : {expected.get(), late.get(), restored.get()}) solver->advance(60);
        CHECK(stateHash(late->state()) == stateHash(expected->state()));
        CHECK(saveState(plain, *restored) == saveState(plain, *late));
        CHECK(diagnose(plain, late->state()).bondsBroken > 0);
    }
}

TEST_CASE("an object that a blast throws at a wall hits it") {
    WorldDescription d = block({12, 12, 1}, softElastic());
    d.bodies[0].size = {0.6, 0.6, 0.05};
    d.materials[0].youngModulus = 1e8;
    d.bodies[0].anchors = {Side::Bottom, Side::Top, Side::Left, Side::Right};
    d.contact = true;
    // In 5 ms and at once, from near and from afar: both beyond what a search looks at for a ball
    // that rests. (What is thrown at 600 m/s goes through so thin a wall.)
    for (const double speed : {50.0, 200.0})
        for (const double steps : {15.0, 1.0})
            for (const double distance : {0.08, 0.6}) {
                d.objects = {ball(0.01, 0.01, {0.02, 0.31, distance}, {0, 0, 0})};
                EventDescription push = blast(d, {0, 0.3, distance}, 0.07, steps);
                push.time = 1.5 * d.step;  // between two searches
                push.vector = {0, 0, -speed};
                push.radius = distance > 0.1 ? 0.5 : 0.05;  // the wall itself is out of reach
                const World world(d);
                for (const SolverUnderTest& under : touchingSolvers()) {
                    INFO(under.name << ", " << speed << " m/s, " << steps << " steps, " << distance
                                    << " m");
                    const auto solver = under.make(world);
                    solver->push(world.makeEvent(push));
                    solver->advance(static_cast<int>(2 * distance / speed / d.step) + 60);
                    const State state = solver->state();
                    CHECK(state.objects[0].position[2] > 0.02);
                    CHECK(diagnose(world, state).nan == 0);
                    CHECK(std::any_of(state.velocity.begin(), state.velocity.end(),
                                      [](const Vec3& v) { return !v.isZero(0); }));
                }
            }
}

TEST_CASE("a sleeping wall wakes for an object that a blast throws at it") {
    Material material = softElastic();
    material.damping = 2;
    WorldDescription d = block({6, 6, 1}, material);
    d.contact = true;
    d.objects = {ball(0.1, 5, {0, 0.3, 1}, {0, 0, 0})};
    const World world(d);
    EventDescription push = blast(d, {0, 0.3, 1.1}, 0.5, 1);
    push.vector = {0, 0, -60};
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (!under.sleeps) continue;
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(2900);
        REQUIRE(solver->asleep(0));
        REQUIRE(solver->objectAsleep(0));
        solver->push(world.makeEvent(push, 2900.5 * d.step));
        // 0.85 m of way at 60 m/s, sooner than a second look, then 0.02 s.
        solver->advance(45 + 60);
        CHECK(!solver->asleep(0));
        const State state = solver->state();
        CHECK(diagnose(world, state).momentum[2] == Approx(-300).epsilon(0.1));
        CHECK(state.objects[0].velocity[2] > -59);
        CHECK(state.velocity[0][2] < 0);
    }
}
