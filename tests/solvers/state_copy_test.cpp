// States that are copied on their way: Solver::makeStateCopy().
#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "support/object_worlds.hpp"
#include "support/same_body.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("state copies are the states at which they began, whatever comes after") {
    WorldDescription d = block({5, 4, 2}, brittle());
    d.bodies[0].anchors = {Side::Bottom};
    BodyDescription other = d.bodies[0];
    other.name = "other";
    other.position = {3, 0, 0};
    d.bodies.push_back(other);
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    d.objects = {ball(0.1, 20, {0.1, 0.2, 0.4}, {0, 0, -25})};
    const World world(d);
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto solver = under.make(world);
        const auto first = solver->makeStateCopy(), second = solver->makeStateCopy();
        const bool onCpu = under.name == "cpu" || under.name == "reference";
        REQUIRE((first == nullptr) == onCpu);
        if (!first) continue;
        solver->advance(60);
        solver->setPresent(1, false);
        solver->releaseAnchors(0);
        first->start();
        const State then = solver->state();
        solver->advance(30);
        second->start();
        const State later = solver->state();
        solver->setPresent(1, true);
        solver->advance(30);
        const auto same = [&](const State& a, const State& b) {
            CHECK(a.step == b.step);
            CHECK(a.absent == b.absent);
            CHECK(a.released == b.released);
            CHECK(a.objects == b.objects);
            for (int body = 0; body < 2; ++body) CHECK(sameBody(world, a, b, body));
        };
        same(first->take(), then);
        same(second->take(), later);
        first->start();
        same(first->take(), solver->state());
        CHECK(diagnose(world, then).bondsBroken > 0);
        CHECK(stateHash(then) != stateHash(later));
    }
}
