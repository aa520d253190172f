// Anchors that let go while time runs: Solver::releaseAnchors().
#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/pieces.hpp"
#include "core/saved_state.hpp"
#include "support/object_worlds.hpp"
#include "support/same_body.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A wall that a ball breaks, 3 cm over the ground, and another one beside it that a push breaks.
/// `anchored`: whether the first is held at the top.
WorldDescription hungWall(bool anchored) {
    WorldDescription d = block({5, 4, 2}, brittle());
    d.bodies[0].position = {0, 0.03, 0};
    if (anchored) d.bodies[0].anchors = {Side::Top};
    BodyDescription other = d.bodies[0];
    other.name = "other";
    other.position = {3, 0, 0};
    other.anchors = {Side::Bottom};
    d.bodies.push_back(other);
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    d.objects = {ball(0.1, 20, {0.1, 0.2, 0.4}, {0, 0, -25})};
    d.events = {hit(1, {0, 0.3, 0}, {0, 0, 8})};
    return d;
}

}  // namespace

TEST_CASE("anchors: a body whose anchors let go at once is one that never had any, to the bit") {
    const World held(hungWall(true)), loose(hungWall(false));
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto released = under.make(held), without = under.make(loose),
                   anchored = under.make(held);
        released->releaseAnchors(0);
        released->releaseAnchors(0);  // as they have already
        without->releaseAnchors(0);   // there are none
        for (const auto& solver : {released.get(), without.get(), anchored.get()})
            solver->advance(160);
        const State a = released->state(), b = without->state(), c = anchored->state();
        CHECK(a.released == std::vector{0});
        CHECK(b.released.empty());
        CHECK(c.released.empty());
        CHECK(brokenBonds(held, a) > 10);
        for (int body = 0; body < 2; ++body) CHECK(sameBody(held, a, b, body));
        CHECK(a.objects == b.objects);
        CHECK_FALSE(sameBody(held, a, c, 0));
        // Far away nothing is different.
        CHECK(sameBody(held, a, c, 1));
        CHECK(stateHash(a) != stateHash(b));
    }
}

TEST_CASE("anchors: what held lets go in the midst of it, and other bodies keep their bits") {
    const World world(hungWall(true));
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto released = under.make(world), anchored = under.make(world);
        const auto both = [&](int steps) {
            released->advance(steps);
            anchored->advance(steps);
        };
        both(30);  // no step at which contacts are searched for
        const auto anchoredPieces = [&](const State& state) {
            int count = 0;
            for (const PieceMotion& piece : pieceMotions(world, state, findPieces(world, state)))
                count += piece.anchored && piece.body == 0;
            return count;
        };
        CHECK(anchoredPieces(released->state()) >= 1);
        released->releaseAnchors(0);
        both(90);
        const State a = released->state(), b = anchored->state();
        CHECK(anchoredPieces(a) == 0);
        CHECK(anchoredPieces(b) >= 1);
        CHECK(sameBody(world, a, b, 1));
        double top = 0;  // of what was held
        int held = 0;
        for (int node = 0; node < kCorners * world.bodies()[0].cellCount(); ++node)
            if (world.anchored(node)) {
                top += a.displacement[node][1];
                ++held;
                CHECK(b.displacement[node] == Vec3::Zero());
            }
        // 30 ms of fall are 4.4 mm, less what the wall, let go, shrinks to that had hung from it.
        CHECK(top / held < -0.0015);

        // The state says it all, and so does a saved one, to the bit.
        const std::vector<std::byte> bytes = saveState(world, *released);
        const auto fromState = under.make(world), fromBytes = under.make(world);
        fromState->setState(a);
        CHECK(fromState->state().released == std::vector{0});
        restoreState(world, *fromBytes, bytes);
        for (const auto& solver : {released.get(), fromBytes.get()}) solver->advance(33);
        CHECK(saveState(world, *fromBytes) == saveState(world, *released));

        // Anew, they hold.
        released->setPresent(0, false);
        released->setPresent(0, true);
        CHECK(released->state().released.empty());
        released->advance(100);
        const State anew = released->state();
        for (int node = 0; node < kCorners * world.bodies()[0].cellCount(); ++node)
            if (world.anchored(node)) CHECK(anew.displacement[node] == Vec3::Zero());
    }
}

TEST_CASE("anchors: a sleeping body whose anchors let go wakes and falls, and nobody else") {
    WorldDescription d = hungWall(true);
    d.objects.clear();
    d.events.clear();
    d.materials[0].damping = 10;
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (!under.sleeps || under.name == "auto") continue;
        INFO(under.name);
        const auto solver = under.make(world);
        for (int i = 0; i < 20 && !(solver->asleep(0) && solver->asleep(1)); ++i)
            solver->advance(600);
        REQUIRE(solver->asleep(0));
        REQUIRE(solver->asleep(1));
        solver->releaseAnchors(0);
        CHECK_FALSE(solver->asleep(0));
        CHECK(solver->asleep(1));
        solver->advance(150);
        // 50 ms of fall are 12 mm.
        CHECK(solver->state().displacement[0][1] < -0.008);
        CHECK(solver->asleep(1));
    }
}

TEST_CASE("anchors: what is released where nothing pulls drifts and does not fall asleep at once") {
    // Without gravity a body that nothing holds sleeps only when it next to stands still.
    WorldDescription d = block({2, 2, 2}, softElastic());
    d.bodies[0].anchors = {Side::Left};
    d.events = {hit(0, {0.1, 0.1, 0}, {0, 0, 0.004})};
    d.events[0].radius = 1;
    const World world(d);
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->releaseAnchors(0);
        solver->advance(6000);
        // 4 mm/s for two seconds, less what drag takes.
        CHECK(solver->state().displacement[0][2] > 0.001);
    }
}

TEST_CASE("anchors: a push where anchors have let go has all the mass there to move") {
    WorldDescription d = hungWall(true);
    const World held(d);
    d.bodies[0].anchors.clear();
    const World loose(d);
    EventDescription push = hit(0, {0, 0.4, 0}, {0, 0, 3});  // the top, as far as the next nodes
    push.kind = EventDescription::Kind::Impulse;
    CHECK(held.makeEvent(push).acceleration.norm() >
          1.1 * loose.makeEvent(push).acceleration.norm());
    CHECK(held.makeEvent(push, 0, true).acceleration == loose.makeEvent(push).acceleration);
    push.point = {0.05, 0.4, 0};
    push.radius = 0.01;
    CHECK_THROWS_AS(held.makeEvent(push), InputError);
    CHECK(held.makeEvent(push, 0, true).acceleration.norm() > 0);
}
