// Bodies at rest sleep, on the solvers that let them (core/sleep.hpp).
#include "core/sleep.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "core/body_host.hpp"
#include "core/diagnostics.hpp"
#include "core/rest_islands.hpp"
#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

std::vector<SolverUnderTest> sleepers() {
    std::vector<SolverUnderTest> result = solversUnderTest();
    std::erase_if(result, [](const SolverUnderTest& under) { return !under.sleeps; });
    REQUIRE(!result.empty());
    return result;
}

}  // namespace

TEST_CASE("a settled wall falls asleep, does not change by a bit, and a push wakes it") {
    Material material = brittle();
    material.damping = 10;
    WorldDescription d = block({5, 4, 1}, material);
    BodyDescription other = d.bodies[0];
    other.position = {2, 0, 0};
    d.bodies.push_back(other);
    d.bodies[0].anchors = {Side::Bottom};  // the second one merely stands there
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    d.events = {hit(0, {0, 0.3, 0}, {0, 0, -1})};
    d.events[0].time = 3.0101;
    const World world(d);
    for (const SolverUnderTest& under : sleepers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        CHECK(!solver->asleep(0));
        solver->advance(7500);  // 2.5 s
        REQUIRE(solver->asleep(0));
        REQUIRE(solver->asleep(1));
        const State asleep = solver->state();
        for (const Vec3& v : asleep.velocity) CHECK(v == Vec3(0, 0, 0));
        solver->advance(1530);
        CHECK(solver->asleep(0));
        CHECK(stateHash(solver->state()) == stateHash(asleep));
        CHECK(solver->state().slow == asleep.slow);
        CHECK(solver->state().step == 9030);
        solver->advance(10);  // the push starts within step 9030
        CHECK(!solver->asleep(0));
        CHECK(solver->asleep(1));
        const State awake = solver->state();
        const int half = world.nodeCount() / 2;
        CHECK(awake.velocity[half - 2] != Vec3(0, 0, 0));
        for (int node = half; node < world.nodeCount(); ++node) {
            CHECK(awake.displacement[node] == asleep.displacement[node]);
            CHECK(awake.velocity[node] == asleep.velocity[node]);
        }
        // A body that is given another state goes on from there, and others sleep on.
        if (auto* host = dynamic_cast<BodyHost*>(solver.get())) {
            State pushed = awake;
            for (int node = 0; node < half; ++node) pushed.velocity[node] += Vec3(0, 0.25, 0);
            host->adopt({0}, pushed);
            CHECK(stateHash(solver->state()) == stateHash(pushed));
            CHECK(!solver->asleep(0));
            CHECK(solver->asleep(1));
        }
        solver->setState(asleep);
        CHECK(!solver->asleep(1));
    }
}

TEST_CASE("turned bodies that stand, lie and lie on each other fall asleep", "[long]") {
    Material material = brittle();
    material.damping = 10;
    material.friction = 1;
    WorldDescription d = block({5, 4, 1}, material);
    d.bodies[0].orientation = Eigen::AngleAxisd(0.5, Vec3::UnitY());
    d.bodies[0].anchors = {Side::Bottom};
    BodyDescription lies = d.bodies[0];
    lies.anchors.clear();
    lies.cells = {4, 3, 2};
    lies.size = {0.4, 0.3, 0.2};
    lies.position = {-2, 0.1, 0};
    lies.orientation = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX());
    d.bodies.push_back(lies);
    BodyDescription top = lies;
    top.position = {-2, 0.3, 0.04};
    top.orientation = Eigen::AngleAxisd(0.3, Vec3::UnitY()) * top.orientation;
    d.bodies.push_back(top);
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    const World world(d);
    for (const SolverUnderTest& under : sleepers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(7500);  // 2.5 s
        for (int body = 0; body < 3; ++body) {
            CAPTURE(body);
            CHECK(solver->asleep(body));
        }
        CHECK(diagnose(world, solver->state()).bondsBroken == 0);
    }
}

TEST_CASE("pieces that fell to the ground fall asleep") {
    Material material = brittle();
    material.strength = material.boundaryStrength = {4e3, 4e3, 4e3};
    WorldDescription d = block({6, 5, 1}, material);
    d.bodies[0].anchors = {Side::Bottom};
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    d.events = {hit(0, {0, 0.3, 0}, {1, 1, -4})};
    const World world(d);
    for (const SolverUnderTest& under : sleepers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(300);
        CHECK(!solver->asleep(0));
        for (int second = 0; second < 20 && !solver->asleep(0); ++second) solver->advance(3000);
        CHECK(solver->asleep(0));
        CHECK(diagnose(world, solver->state()).pieces > 1);
    }
}

TEST_CASE("a falling body does not fall asleep") {
    WorldDescription d = block({2, 2, 2}, softElastic());
    d.gravity = {0, -9.81, 0};
    d.bodies[0].position = {0, 100, 0};
    const World world(d);
    for (const SolverUnderTest& under : sleepers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        for (int i = 0; i < 20; ++i) {
            solver->advance(300);
            CHECK(!solver->asleep(0));
        }
    }
}

namespace {

ObjectDescription movable(ObjectShape shape, const Vec3& halfSize, double mass,
                          const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
    ObjectDescription object;
    object.shape = shape;
    object.halfSize = halfSize;
    object.mass = mass;
    object.position = position;
    object.velocity = velocity;
    return object;
}

ThrowDescription thrownAway(int object, double time) {
    return {time, object, {50, 1, 0}, {1, 0, 0}, {0, 0, 0}};
}

/// s: when what something rests on leaves. Half a second is what it takes to fall asleep.
constexpr double kLeaves = 1.5;

/// A block, calm from the start, on the ground, and gravity.
WorldDescription grounded(const IVec3& cells) {
    Material material = softElastic();
    material.youngModulus = 1e9;  // as stiff as the step allows
    material.damping = 5;
    WorldDescription d = block(cells, material);
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    return d;
}

}  // namespace

TEST_CASE("nothing stops in the air for being slow a moment") {
    WorldDescription d = grounded({1, 1, 1});  // it sleeps long before
    d.bodies[0].position = {30, 0, 0};
    d.objects = {movable(ObjectShape::Sphere, {0.1, 0.1, 0.1}, 1, {0, 1, 0}, {0, 12, 0}),
                 // A swing of 2.5 cm, slower than kStirringSpeed for most of the time.
                 movable(ObjectShape::Sphere, {0.1, 0.1, 0.1}, 1, {5.025, 2, 0}),
                 // One of 60 degrees.
                 movable(ObjectShape::Sphere, {0.1, 0.1, 0.1}, 1,
                         {10 + 2 * std::sin(1.047), 4 - 2 * std::cos(1.047), 0}),
                 // Floats past, slower than what sleeps on the ground may be.
                 movable(ObjectShape::Sphere, {0.1, 0.1, 0.1}, 1, {15, 0.0999, 0}, {0, 2, 0})};
    d.objects[1].hungFrom = Vec3(5, 6, 0);
    d.objects[2].hungFrom = Vec3(10, 4, 0);
    for (ObjectDescription& object : d.objects) object.drag = 0;
    d.objects[3].restitution = 0.9;
    const World world(d);
    cpu::ReferenceSolver reference(world);
    const int steps[] = {3672, 900, 1500};  // 1.224 s: the top of the flight
    std::vector<State> expected;
    for (const int some : steps) {
        reference.advance(some);
        expected.push_back(reference.state());
    }
    CHECK(std::abs(expected[0].objects[0].velocity[1]) < 0.05);
    for (const SolverUnderTest& under : sleepers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        for (std::size_t i = 0; i < std::size(steps); ++i) {
            solver->advance(steps[i]);
            const State state = solver->state();
            CHECK(solver->asleep(0));
            for (std::size_t object = 0; object < d.objects.size(); ++object) {
                CAPTURE(i, object);
                CHECK(!solver->objectAsleep(static_cast<int>(object)));
                // Rounding of single precision over thousands of steps of up to 4 mm.
                CHECK(
                    (state.objects[object].position - expected[i].objects[object].position).norm() <
                    2e-3);
            }
        }
    }
}

TEST_CASE("what rests on something wakes and falls when that leaves", "[long]") {
    struct Case {
        const char* what;
        WorldDescription world;
        int body, object;    ///< what must fall; -1: none
        double from;         ///< m, where its lowest point was at least
        double falls = 0.1;  ///< m, in 0.4 s
    };
    std::vector<Case> cases;
    {
        WorldDescription d = grounded({4, 2, 4});
        d.bodies[0].position = {0, 0.3, 0};
        d.objects = {movable(ObjectShape::Box, {0.2, 0.15, 0.2}, 50, {0, 0.15, 0})};
        d.throws = {thrownAway(0, kLeaves)};
        cases.push_back({"a body on an object", d, 0, -1, 0.29});
    }
    {
        WorldDescription d = grounded({4, 2, 4});
        d.objects = {movable(ObjectShape::Box, {0.1, 0.1, 0.1}, 5, {0, 0.3, 0})};
        d.events = {hit(0, {0, 0.1, 0}, {30, 0, 0})};
        d.events[0].time = kLeaves;
        cases.push_back({"an object on a body", d, -1, 0, 0.19});
    }
    {
        WorldDescription d = grounded({1, 1, 1});
        d.bodies[0].position = {20, 0, 0};
        d.objects = {movable(ObjectShape::Box, {0.2, 0.1, 0.2}, 5, {0, 0.1, 0}),
                     movable(ObjectShape::Box, {0.2, 0.1, 0.2}, 5, {0, 0.3, 0})};
        d.throws = {thrownAway(0, kLeaves)};
        cases.push_back({"an object on an object", d, -1, 1, 0.19});
    }
    {
        WorldDescription d = grounded({4, 2, 4});
        BodyDescription upper = d.bodies[0];
        upper.position = {0, 0.2, 0};
        d.bodies.push_back(upper);
        d.events = {hit(0, {0, 0.1, 0}, {30, 0, 0})};
        d.events[0].time = kLeaves;
        d.events[0].radius = 1;
        cases.push_back({"a body on a body", d, 1, -1, 0.19});
    }
    {
        WorldDescription d = grounded({8, 1, 2});  // a lintel on two posts, one of which leaves
        d.bodies[0].position = {0, 0.4, 0};
        d.objects = {movable(ObjectShape::Box, {0.1, 0.2, 0.1}, 20, {-0.3, 0.2, 0}),
                     movable(ObjectShape::Box, {0.1, 0.2, 0.1}, 20, {0.3, 0.2, 0})};
        d.throws = {thrownAway(1, kLeaves)};
        cases.push_back({"a lintel on posts", d, 0, -1, 0.38});
    }
    {
        WorldDescription d = grounded({1, 1, 1});
        d.bodies[0].position = {20, 0, 0};
        d.objects = {movable(ObjectShape::Box, {0.03, 0.4, 0.2}, 5, {-0.11, 0.40, 0}),
                     movable(ObjectShape::Box, {0.2, 0.4, 0.2}, 200, {0.2, 0.4, 0})};
        d.objects[0].orientation = Eigen::AngleAxisd(-0.2, Vec3::UnitZ());
        for (ObjectDescription& object : d.objects) object.friction = 2;
        d.throws = {thrownAway(1, kLeaves)};
        cases.push_back({"a board that leans on a box", d, -1, 0, 0.38, 0.02});
    }
    for (const Case& c : cases) {
        const World world(c.world);
        const auto lowest = [&](const State& state) {
            if (c.object >= 0) return state.objects[c.object].position[1];
            double low = 1e9;
            const Body& body = world.bodies()[c.body];
            for (int node = kCorners * body.firstCell;
                 node < kCorners * (body.firstCell + body.cellCount()); ++node)
                low = std::min(low, world.restPosition(node)[1] + state.displacement[node][1]);
            return low;
        };
        for (const SolverUnderTest& under : sleepers()) {
            INFO(under.name << ", " << c.what);
            const auto solver = under.make(world);
            solver->advance(static_cast<int>(kLeaves * 3000) - 50);
            const auto sleeps = [&] {
                return c.object >= 0 ? solver->objectAsleep(c.object) : solver->asleep(c.body);
            };
            CHECK(sleeps());
            const State before = solver->state();
            CHECK(lowest(before) > c.from);
            solver->advance(50 + 200);
            CHECK(!sleeps());
            solver->advance(1000);  // 0.4 s, in which what falls freely falls 0.8 m
            const State after = solver->state();
            CHECK(lowest(after) < lowest(before) - c.falls);
        }
    }
}

TEST_CASE("waking costs nothing for what is not concerned") {
    WorldDescription d = grounded({2, 2, 2});
    BodyDescription other = d.bodies[0];
    other.position = {1, 0, 0};  // 0.8 m away
    d.bodies.push_back(other);
    d.objects = {movable(ObjectShape::Box, {0.1, 0.1, 0.1}, 5, {0, 0.3, 0}),
                 movable(ObjectShape::Box, {0.1, 0.1, 0.1}, 5, {1, 0.3, 0})};
    d.events = {hit(0, {0, 0.1, 0}, {0, 0.5, 0})};
    d.events[0].time = kLeaves;
    const World world(d);
    for (const SolverUnderTest& under : sleepers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(4400);
        const State asleep = solver->state();
        for (int i = 0; i < 2; ++i) CHECK((solver->asleep(i) && solver->objectAsleep(i)));
        solver->advance(200);
        CHECK((!solver->asleep(0) && !solver->objectAsleep(0)));
        CHECK((solver->asleep(1) && solver->objectAsleep(1)));
        const State state = solver->state();
        CHECK(state.objects[1] == asleep.objects[1]);
        for (int node = world.nodeCount() / 2; node < world.nodeCount(); ++node)
            CHECK(state.displacement[node] == asleep.displacement[node]);
    }
}

TEST_CASE("members of an island fall asleep and wake together") {
    using Status = RestIslands::Status;
    RestIslands islands(6);
    // 0 - 1 - 2 touch, 2 is restless; 3 - 4 touch; 5 is not there.
    std::vector<Status> status{Status::Ready, Status::Ready, Status::Restless,
                               Status::Ready, Status::Ready, Status::Apart};
    CHECK(islands.settle(status, {{0, 1}, {1, 2}, {3, 4}}) == std::vector{3, 4});
    CHECK(islands.wake(0).empty());
    status[2] = Status::Ready;
    status[3] = status[4] = Status::Asleep;
    // Now all are ready, and 2 has come to lie against 3.
    CHECK(islands.settle(status, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}) == std::vector{0, 1, 2});
    CHECK(islands.wake(4) == std::vector{0, 1, 2, 3, 4});
    CHECK(islands.wake(0).empty());
}

TEST_CASE("no push is slept through, though it be as short as a step") {
    WorldDescription d = block({2, 2, 1}, softElastic());
    d.materials[0].damping = 10;
    d.bodies[0].anchors = {Side::Bottom};
    const World calm(d);
    EventDescription push = hit(0, {0, 0.2, 0}, {0, 0, 0.3});
    push.duration = d.step;
    EventDescription blast = push;  // at the same place
    blast.body = kEveryBody;
    blast.point += d.bodies[0].position;
    for (const SolverUnderTest& under : sleepers()) {
        INFO(under.name);
        const auto watched = under.make(calm);
        while (!watched->asleep(0)) {
            watched->advance(1);
            REQUIRE(watched->state().step < 9000);
        }
        // Around the step in which it falls asleep when nothing comes.
        const auto fell = static_cast<int>(watched->state().step) - 1;
        for (int step = fell - 2; step <= fell + 2; ++step) {
            INFO(step);
            for (const EventDescription& event : {push, blast}) {
                INFO((event.body == kEveryBody ? "blast" : "push"));
                d.events = {event};
                d.events[0].time = step * d.step;
                const World pushed(d);
                const auto solver = under.make(pushed);
                solver->advance(step + 1);
                double fastest = 0;
                for (const Vec3& v : solver->state().velocity)
                    fastest = std::max(fastest, v.norm());
                CHECK(fastest > 0.1);
            }
        }
    }
}
