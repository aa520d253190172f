// Bodies at rest sleep, on the solvers that let them (core/sleep.hpp).
#include "core/sleep.hpp"
#include "catch.hpp"
#include "core/body_host.hpp"
#include "core/diagnostics.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;

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
