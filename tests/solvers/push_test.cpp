// Pushes while time runs (Solver::push()), and blasts, which push what is near wherever it is.
#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Two walls that break, in contact with each other, the ground and a ball.
WorldDescription fragileWorld() {
    WorldDescription d = block({7, 5, 2}, brittle());
    d.bodies[0].anchors = {Side::Bottom};
    BodyDescription other = d.bodies[0];
    other.name = "other";
    other.anchors.clear();
    other.position = {0.1, 0, 0.5};
    d.bodies.push_back(other);
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    ObjectDescription ball;
    ball.name = "ball";
    ball.position = Vec3(0, 0.2, 1);
    d.objects = {ball};
    return d;
}

/// On all of them: without one of them the world would be another.
std::vector<EventDescription> fragileEvents(double step) {
    using Kind = EventDescription::Kind;
    EventDescription patch = hit(0, {0.2, 0.3, 0.1}, {0, 1, -9});
    patch.time = 8 * step;
    EventDescription impulse = patch;
    impulse.kind = Kind::Impulse;
    impulse.time = 20.25 * step;
    impulse.body = 1;
    impulse.vector = {2, 0, 9};
    EventDescription force = impulse;
    force.kind = Kind::Force;
    force.vector = {0, 900, 0};
    EventDescription blast = patch;
    blast.time = 33 * step;
    blast.body = kEveryBody;
    blast.point = {0.1, 0.2, 0.25};
    blast.radius = 0.4;
    blast.vector = {0, 2, 0};
    blast.outward = 12;
    blast.falloff = true;
    // In order of body, as they add up where they act at once: blasts, the first wall's, the
    // other's.
    return {blast, patch, force, impulse};
}

EventDescription blastOf(const Vec3& point, double radius, double step) {
    EventDescription blast;
    blast.kind = EventDescription::Kind::Velocity;
    blast.body = kEveryBody;
    blast.point = point;
    blast.radius = radius;
    blast.duration = step;  // all of it in one step
    return blast;
}

}  // namespace

TEST_CASE("what is pushed while time runs breaks as by the same events of the world, to the bit") {
    WorldDescription d = fragileWorld();
    const World plain(d);
    d.events = fragileEvents(d.step);
    const World planned(d);
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto expected = under.make(planned), pushed = under.make(plain);
        std::vector<EventDescription> left = d.events;
        for (int step = 0; step < 72; step += 4) {
            // As late as may be: in the advance that they begin in.
            std::erase_if(left, [&](const EventDescription& event) {
                const bool now = event.time < (step + 4) * d.step;
                if (now) pushed->push(plain.makeEvent(event));
                return now;
            });
            expected->advance(4);
            pushed->advance(4);
            REQUIRE(stateHash(pushed->state()) == stateHash(expected->state()));
        }
        CHECK(left.empty());
        const State state = pushed->state();
        CHECK(state.slow == expected->state().slow);
        CHECK(diagnose(plain, state).bondsBroken > 10);
        CHECK(state.pushes.empty());
    }
}

TEST_CASE("an object that is thrown while time runs flies and hits as by a throw of the world") {
    WorldDescription d = fragileWorld();
    const World plain(d);
    ThrowDescription thrown;
    thrown.time = 8 * d.step;
    thrown.object = 0;
    thrown.from = {0.05, 0.3, 0.9};
    thrown.velocity = {0, 1, -20};
    thrown.spin = {5, 0, 0};
    d.throws = {thrown};
    const World planned(d);
    for (const SolverUnderTest& under : exactSolvers()) {
        if (!under.contact) continue;
        INFO(under.name);
        const auto expected = under.make(planned), late = under.make(plain);
        late->advance(8);
        late->putObject(0, planned.throws()[0].state);
        late->advance(72);
        expected->advance(8);
        expected->advance(72);
        const State state = late->state();
        CHECK(stateHash(state) == stateHash(expected->state()));
        CHECK(state.slow == expected->state().slow);
        CHECK(diagnose(plain, state).bondsBroken > 0);
    }
}

TEST_CASE("a state has the pushes that are under way, and goes on with them to the bit") {
    WorldDescription d = fragileWorld();
    d.contact = false;
    d.objects.clear();
    const World world(d);
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto first = under.make(world), second = under.make(world);
        for (const EventDescription& event : fragileEvents(d.step))
            first->push(world.makeEvent(event));
        first->advance(34);
        const State between = first->state();
        CHECK(between.pushes.size() == 3);  // the patch is over
        second->setState(between);
        first->advance(40);
        second->advance(40);
        CHECK(stateHash(first->state()) == stateHash(second->state()));
        // Another state has other pushes, here none.
        second->setState(world.initialState());
        second->advance(1);
        CHECK(second->state().pushes.empty());
    }
}

TEST_CASE("a blast gives each node the speed that is described, by where the node is") {
    WorldDescription d = block({4, 3, 2}, softElastic());
    BodyDescription anchored = d.bodies[0];
    anchored.anchors = {Side::Left};
    anchored.position = {0, 0.4, 0};
    d.bodies.push_back(anchored);
    const World world(d);
    const Vec3 moved(3, -1, 2);
    EventDescription blast = blastOf({3.12, -0.63, 2.07}, 0.31, d.step);
    blast.vector = {1, 0, -4};
    blast.outward = 6;
    for (const bool falloff : {false, true})
        for (const SolverUnderTest& under : solversUnderTest()) {
            INFO(under.name << ", falloff " << falloff);
            blast.falloff = falloff;
            const auto solver = under.make(world);
            State state = world.initialState();
            for (Vec3& u : state.displacement) u = moved;
            solver->setState(state);
            solver->push(world.makeEvent(blast));
            solver->advance(1);
            int inside = 0, outside = 0;
            const State after = solver->state();
            for (int node = 0; node < world.nodeCount(); ++node) {
                const Vec3 away = world.restPosition(node) + moved - blast.point;
                const double share = away.squaredNorm() / (blast.radius * blast.radius);
                const bool hit = share < 1 && !world.anchored(node);
                ++(hit ? inside : outside);
                Vec3 expected(0, 0, 0);
                if (hit) expected = blast.vector + blast.outward * away.normalized();
                if (hit && falloff) expected *= 1 - share;
                // The ball's place is in single precision for all of them (6e-8). Near 3 m that is
                // a thirtieth of the distance as good, and so is the direction, of some 10 m/s.
                CHECK((after.velocity[node] - expected).norm() < 30 * 10 * 6e-8);
            }
            CHECK(inside > 20);
            CHECK(outside > 20);
            // At rest they were elsewhere: a patch of the same ball would have had none of them.
            blast.body = 0;
            CHECK_THROWS_AS(world.makeEvent(blast), InputError);
            blast.body = kEveryBody;
        }
}

TEST_CASE("a blast tears no joined nodes apart by itself") {
    const World world(block({5, 4, 3}, softElastic()));
    EventDescription blast = blastOf({0.05, 0.2, 0.05}, 0.3, world.step());
    blast.outward = 9;
    blast.falloff = true;
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->push(world.makeEvent(blast));
        solver->advance(25);
        const State state = solver->state();
        CHECK(state.velocity[0] != Vec3(0, 0, 0));
        CHECK(tornNodes(world, state) == 0);
    }
}

TEST_CASE("a blast wakes what sleeps in its reach, and nothing else") {
    Material material = brittle();
    material.damping = 10;
    WorldDescription d = block({3, 2, 1}, material);
    d.bodies[0].anchors = {Side::Bottom};
    BodyDescription far = d.bodies[0];
    far.name = "far";
    far.position = {2, 0, 0};
    d.bodies.push_back(far);
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    const World world(d);
    for (const SolverUnderTest& under : solversUnderTest()) {
        if (!under.sleeps) continue;
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(6000);
        REQUIRE(solver->asleep(0));
        REQUIRE(solver->asleep(1));
        const State asleep = solver->state();
        EventDescription blast = blastOf({2, 0.1, 0.3}, 0.5, d.step);
        blast.time = 6010 * d.step;
        blast.outward = 1;
        solver->push(world.makeEvent(blast));
        solver->advance(8);
        CHECK(solver->asleep(1));
        solver->advance(8);
        CHECK(!solver->asleep(1));
        CHECK(solver->asleep(0));
        const State awake = solver->state();
        const int half = world.nodeCount() / 2;
        CHECK(awake.displacement[half + 2] != asleep.displacement[half + 2]);
        for (int node = 0; node < half; ++node)
            CHECK(awake.displacement[node] == asleep.displacement[node]);
    }
}

TEST_CASE("pushes that are over are forgotten") {
    const World world(block({2, 2, 1}, softElastic()));
    EventSchedule schedule(world);
    EventDescription push = hit(0, {0, 0.1, 0}, {0, 0, 1});
    std::size_t most = 0;
    for (int step = 0; step < 100'000; ++step) {
        push.time = step * world.step();
        schedule.add(world.makeEvent(push), step);
        most = std::max(most, schedule.all().size());
        // Those that act now are all there: one began in each of the last fifteen steps.
        if (step % 1000 == 999) {
            CHECK(schedule.added(step).size() == 15);
            CHECK(schedule.nextPush(0, step) == step);
            CHECK(schedule.nextPush(0, step + 20) > step + 20);
        }
    }
    // Half a second of them, in which a solver may still ask, and as many again until it is tidied.
    CHECK(most < 3500);
}
