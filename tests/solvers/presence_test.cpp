// Bodies that are put there and taken away while time runs: Solver::setPresent().
#include "catch.hpp"
#include "core/contact.hpp"
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

/// A wall that a ball and a push break, a loose block that falls beside it, and far away a block,
/// body 2, that falls onto the ground. `guest`: whether that one is there from the start.
WorldDescription breakingWithGuest(bool guest) {
    WorldDescription d = block({5, 4, 2}, brittle());
    d.bodies[0].anchors = {Side::Bottom};
    BodyDescription loose = d.bodies[0];
    loose.name = "loose";
    loose.anchors.clear();
    loose.size = {0.2, 0.2, 0.2};
    loose.cells = {2, 2, 2};
    loose.position = {0.1, 0.45, 0.02};
    BodyDescription far = loose;
    far.name = "far";
    far.position = {6, 0.02, 1};
    far.present = guest;
    d.bodies.insert(d.bodies.end(), {loose, far});
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    d.objects = {ball(0.1, 20, {0.1, 0.2, 0.4}, {0, 0, -25})};
    d.events = {hit(0, {0, 0.3, 0}, {0, 0, 8})};
    return d;
}

/// A block that stands on another one. `lower`: whether that one is there from the start.
WorldDescription standingOn(bool lower) {
    Material material = softElastic();
    material.damping = 10;
    WorldDescription d = block({2, 2, 2}, material);
    d.bodies[0].anchors = {Side::Bottom};
    d.bodies[0].present = lower;
    BodyDescription upper = d.bodies[0];
    upper.name = "upper";
    upper.anchors.clear();
    upper.position = {0, 0.2, 0};
    upper.present = true;
    d.bodies.push_back(upper);
    d.gravity = {0, -9.81, 0};
    d.contact = true;
    d.ground = true;
    return d;
}

/// m, mean height of a body's nodes over where they are at rest.
double heightOf(const World& world, const State& state, int index) {
    const Body& body = world.bodies()[index];
    double sum = 0;
    for (int node = kCorners * body.firstCell;
         node < kCorners * (body.firstCell + body.cellCount()); ++node)
        sum += state.displacement[node][1];
    return sum / (kCorners * body.cellCount());
}

}  // namespace

TEST_CASE("presence: bodies that come and go far away change no bit of others") {
    const World world(breakingWithGuest(false));
    const State initial = world.initialState();
    CHECK(initial.absent == std::vector{2});
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto alone = under.make(world), visited = under.make(world);
        CHECK_FALSE(visited->present(2));
        const auto both = [&](int steps) {
            alone->advance(steps);
            visited->advance(steps);
        };
        // Where searches for contacts come anyway.
        REQUIRE(world.contactInterval() == 4);
        both(32);
        CHECK(sameBody(world, visited->state(), initial, 2));
        visited->setPresent(2, true);
        CHECK(visited->present(2));
        CHECK(sameBody(world, visited->state(), initial, 2));
        both(92);
        const State during = visited->state();
        CHECK(during.absent.empty());
        CHECK_FALSE(sameBody(world, during, initial, 2));
        CHECK(heightOf(world, during, 2) < -0.003);  // 30 ms of fall are 4 mm
        visited->setPresent(2, false);
        CHECK(sameBody(world, visited->state(), initial, 2));
        both(48);
        visited->setPresent(2, true);
        both(4);
        visited->setPresent(2, false);
        both(20);
        const State a = alone->state(), b = visited->state();
        CHECK(brokenBonds(world, a) > 10);
        for (int body = 0; body < 3; ++body) CHECK(sameBody(world, a, b, body));
        CHECK(a.objects == b.objects);
        CHECK(stateHash(a) == stateHash(b));
        const Diagnostics x = diagnose(world, a), y = diagnose(world, b);
        CHECK(x.pieces == y.pieces);
        CHECK(x.kinetic == y.kinetic);
        CHECK(x.gravity == y.gravity);
    }
}

TEST_CASE("presence: what is not there bears nothing, and is in no diagnostics") {
    const World world(standingOn(true));
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(60);
        // What weight presses two blocks of E = 1e6 Pa together by is far less than a millimetre.
        CHECK(heightOf(world, solver->state(), 1) > -1e-3);
        solver->setPresent(0, false);
        solver->setPresent(0, false);  // as it is already
        solver->advance(300);
        const State fallen = solver->state();
        CHECK(fallen.absent == std::vector{0});
        // 100 ms of fall are 49 mm, less what drag takes: e^(−10/s · 0.1 s) of the speed is left.
        CHECK(heightOf(world, fallen, 1) < -0.03);
        const Pieces pieces = findPieces(world, fallen);
        CHECK(pieces.count == 1);
        CHECK(pieces.ofCell[0] == -1);
        // The state says it all: another solver goes on from there without the body.
        const auto other = under.make(world);
        other->setState(fallen);
        CHECK_FALSE(other->present(0));
        other->advance(30);
        CHECK(heightOf(world, other->state(), 1) < heightOf(world, fallen, 1));
        other->setState(world.initialState());
        CHECK(other->present(0));
    }
}

TEST_CASE("presence: a body that is put there is whole and holds what comes onto it") {
    const World world(standingOn(false));
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(2);
        CHECK(heightOf(world, solver->state(), 1) < 0);
        solver->setPresent(0, true);
        solver->advance(300);
        const State state = solver->state();
        CHECK(state.absent.empty());
        CHECK(heightOf(world, state, 1) > -1e-3);
        CHECK(brokenBonds(world, state) == 0);
    }
}

TEST_CASE("presence: what sleeps on a body that goes wakes and falls") {
    const World world(standingOn(true));
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (!under.sleeps || under.name == "auto") continue;
        INFO(under.name);
        const auto solver = under.make(world);
        for (int i = 0; i < 20 && !solver->asleep(1); ++i) solver->advance(600);
        REQUIRE(solver->asleep(1));
        const double before = heightOf(world, solver->state(), 1);
        solver->setPresent(0, false);
        CHECK_FALSE(solver->asleep(0));
        CHECK_FALSE(solver->asleep(1));
        solver->advance(150);
        CHECK(heightOf(world, solver->state(), 1) < before - 0.005);
        CHECK_FALSE(solver->asleep(0));
    }
}

TEST_CASE("presence: a body that is put beside a sleeper wakes it, and no other one") {
    WorldDescription d = standingOn(false);
    BodyDescription far = d.bodies[1];
    far.name = "far";
    far.position = {5, 0, 0};
    d.bodies[1].position = {0.2, 0, 0};
    d.bodies.push_back(far);
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (!under.sleeps || under.name == "auto") continue;
        INFO(under.name);
        const auto solver = under.make(world);
        for (int i = 0; i < 20 && !(solver->asleep(1) && solver->asleep(2)); ++i)
            solver->advance(600);
        REQUIRE(solver->asleep(1));
        REQUIRE(solver->asleep(2));
        CHECK_FALSE(solver->asleep(0));
        solver->setPresent(0, true);
        CHECK_FALSE(solver->asleep(1));
        CHECK(solver->asleep(2));
    }
}

TEST_CASE("presence: a body that has gone comes back with what touched it") {
    const World world(standingOn(true));
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        // Some sleep by then.
        for (const int steps : {41, 6000}) {
            solver->advance(steps);
            const std::vector<std::byte> touching = saveState(world, *solver);
            for (const int gone : {0, 1}) {
                solver->setPresent(gone, false);
                solver->advance(8);
                restoreState(world, *solver, touching);
                CHECK(saveState(world, *solver) == touching);
            }
        }
    }
}

TEST_CASE("presence: saved states know which bodies are there, to the bit") {
    const World world(breakingWithGuest(false));
    CHECK(world.fingerprint() != World(breakingWithGuest(true)).fingerprint());
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(50);
        solver->setPresent(2, true);
        solver->setPresent(1, false);
        const std::vector<std::byte> atOnce = saveState(world, *solver);
        solver->advance(33);
        const std::vector<std::byte> later = saveState(world, *solver);
        const auto other = under.make(world);
        for (const std::vector<std::byte>& bytes : {later, atOnce}) {
            restoreState(world, *other, bytes);
            CHECK(other->present(2));
            CHECK_FALSE(other->present(1));
        }
        other->advance(33);
        CHECK(saveState(world, *other) == later);
    }
}
