// Incidents (core/incident.hpp) of every solver: breaks, and on those that have contact, contacts.
#include "core/incident.hpp"

#include <algorithm>
#include <set>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

constexpr int kLook = 50;  // steps

/// Mean place of a cell's corners that have all of these bits, m.
Vec3 centreOf(const World& world, const State& state, int cell, int bits = 0) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (int corner = 0; corner < kCorners; ++corner) {
        if ((corner & bits) != bits) continue;
        const int node = kCorners * cell + corner;
        sum += world.restPosition(node) + state.displacement[node];
        ++count;
    }
    return sum / count;
}

/// Pulled apart from its middle, up to so many m/s.
State pulled(const World& world, double speed) {
    State state = world.initialState();
    double farthest = 0;
    for (int node = 0; node < world.nodeCount(); ++node)
        farthest = std::max(farthest, world.restPosition(node).norm());
    for (int node = 0; node < world.nodeCount(); ++node)
        state.velocity[node] = speed / farthest * world.restPosition(node);
    return state;
}

WorldDescription breakable(const IVec3& cells, FractureMode mode) {
    Material material = brittle();
    material.fracture = mode;
    material.maxStress = 2e4;
    return block(cells, material);
}

/// Bodies of one cell of 0.1 m, 1 kg each; `places` are their centres.
WorldDescription singleCells(const std::vector<Vec3>& places) {
    WorldDescription d = block({1, 1, 1}, softElastic());
    d.materials[0].restitution = 0.5;
    const BodyDescription cell = d.bodies[0];
    d.bodies.clear();
    for (const Vec3& place : places) {
        d.bodies.push_back(cell);
        d.bodies.back().position = place - Vec3(0, 0.05, 0);
    }
    d.contact = true;
    return d;
}

/// kg·m/s.
Vec3 momentumOf(const World& world, const State& state, int cell) {
    Vec3 sum = Vec3::Zero();
    for (int node = kCorners * cell; node < kCorners * (cell + 1); ++node)
        sum += world.nodeMass(node) * state.velocity[node];
    return sum;
}

/// A loose block that lies on the ground and is hit, so that everything touches and breaks.
WorldDescription hitHeap(double length = 0.1) {
    WorldDescription d = breakable({5, 5, 2}, FractureMode::Bond);
    d.bodies[0].size[0] = 5 * length;
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    return d;
}

std::set<std::pair<int, int>> breaksOf(const std::vector<Incident>& incidents) {
    std::set<std::pair<int, int>> result;
    for (const Incident& incident : incidents)
        if (incident.kind == Incident::Kind::Break) result.insert({incident.cell, incident.other});
    return result;
}

}  // namespace

TEST_CASE("every bond that breaks is an incident, where its face then is") {
    for (const FractureMode mode : {FractureMode::Bond, FractureMode::Cell}) {
        const World world(breakable({5, 4, 3}, mode));
        for (const SolverUnderTest& under : solversUnderTest()) {
            INFO(under.name << (mode == FractureMode::Bond ? ", bond" : ", cell"));
            IncidentRing ring;
            const auto solver = under.make(world);
            solver->setIncidents(&ring);
            solver->setState(pulled(world, 6));
            State before = solver->state();
            int broken = 0;
            for (int look = 1; look <= 3; ++look) {
                solver->advance(kLook);
                solver->finish();
                const State after = solver->state();
                std::vector<int> expected;
                for (int bond = 0; bond < world.bondSlots(); ++bond)
                    if (before.damage[bond] < 1 && after.damage[bond] >= 1)
                        expected.push_back(bond);
                const std::vector<Incident> incidents = ring.take();
                REQUIRE(incidents.size() == expected.size());
                broken += static_cast<int>(expected.size());
                for (std::size_t i = 0; i < incidents.size(); ++i) {
                    const Incident& incident = incidents[i];
                    const Incident wanted = breakOf(world, expected[i], look * kLook);
                    CHECK(incident.kind == Incident::Kind::Break);
                    CHECK(incident.step == wanted.step);
                    CHECK(incident.cell == wanted.cell);
                    CHECK(incident.other == wanted.other);
                    CHECK(incident.object == -1);
                    CHECK(incident.impulse == wanted.impulse);
                    const Vec3 face =
                        centreOf(world, after, wanted.cell, 1 << expected[i] % kBondsPerCell);
                    CHECK((incident.place - face).norm() < 1e-6);
                }
                before = after;
            }
            CHECK(broken > 20);
            CHECK(ring.dropped() == 0);
        }
    }
}

TEST_CASE("who never waits reads a look's incidents two looks later") {
    const World world(breakable({5, 4, 3}, FractureMode::Cell));
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        IncidentRing ring;
        const auto solver = under.make(world);
        solver->setIncidents(&ring);
        solver->setState(pulled(world, 6));
        for (int look = 0; look < 3; ++look) solver->advance(kLook);
        const State state = solver->state();
        std::vector<Incident> incidents = ring.take();
        REQUIRE(!incidents.empty());
        CHECK(incidents[0].step == kLook);
        solver->finish();
        for (const Incident& incident : ring.take()) incidents.push_back(incident);
        const auto broken = std::count(state.damage.begin(), state.damage.end(), 1.);
        CHECK(static_cast<std::ptrdiff_t>(incidents.size()) == broken);
        for (std::size_t i = 1; i < incidents.size(); ++i)
            CHECK(incidents[i - 1].step <= incidents[i].step);
    }
}

TEST_CASE("what finds no room is counted") {
    const World world(breakable({12, 12, 12}, FractureMode::Cell));
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        IncidentRing ring(4);
        const auto solver = under.make(world);
        solver->setIncidents(&ring);
        solver->setState(pulled(world, 30));
        solver->advance(kLook);
        solver->finish();
        const State state = solver->state();
        const auto broken = std::count(state.damage.begin(), state.damage.end(), 1.);
        REQUIRE(broken > 4200);  // more than a GPU's look has room for
        CHECK(ring.take().size() == 4);
        CHECK(ring.dropped() == broken - 4);
    }
}

TEST_CASE("two cells that collide are a contact each, with the momentum they exchange") {
    const World world(singleCells({{-0.06, 0, 0}, {0.06, 0, 0}}));
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        IncidentRing ring;
        const auto solver = under.make(world);
        solver->setIncidents(&ring);
        State state = world.initialState();
        for (int node = 0; node < world.nodeCount(); ++node)
            state.velocity[node] = {node < kCorners ? 2. : -2., 0, 0};
        solver->setState(state);
        solver->advance(kLook);
        solver->finish();
        const State after = solver->state();
        const std::vector<Incident> incidents = ring.take();
        REQUIRE(incidents.size() == 2);
        for (int cell = 0; cell < 2; ++cell) {
            const Incident& incident = incidents[cell];
            const Vec3 given = momentumOf(world, after, cell) - momentumOf(world, state, cell);
            CHECK(incident.kind == Incident::Kind::Contact);
            CHECK(incident.step == kLook);
            CHECK(incident.cell == cell);
            CHECK(incident.other == 1 - cell);
            CHECK(incident.object == -1);
            CHECK(given.norm() > 2.9);  // m·(1 + e)·v but for where in a step they met
            CHECK(incident.impulse == Approx(given.norm()).epsilon(1e-5));
            CHECK((incident.place - centreOf(world, after, cell)).norm() < 1e-6);
            CHECK(materialsOf(world, incident) == std::vector<std::string>{"soft", "soft"});
        }
        solver->advance(4 * kLook);
        solver->finish();
        CHECK(ring.take().empty());
    }
}

TEST_CASE("a cell that an object hits is a contact with the object") {
    WorldDescription d = singleCells({{0, 0, 0}, {2, 0, 0}});
    ObjectDescription ball;
    ball.halfSize.setConstant(0.1);
    ball.mass = 0.5;
    ball.drag = 0;
    ball.position = Vec3(0, 0, 1);  // stays there
    d.objects = {ball, ball};
    d.objects[1].position = Vec3(-0.17, 0, 0);
    d.objects[1].velocity = {4, 0, 0};
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        IncidentRing ring;
        const auto solver = under.make(world);
        solver->setIncidents(&ring);
        solver->advance(kLook);
        solver->finish();
        const State after = solver->state();
        const std::vector<Incident> incidents = ring.take();
        REQUIRE(incidents.size() == 1);
        CHECK(incidents[0].cell == 0);
        CHECK(incidents[0].other == -1);
        CHECK(incidents[0].object == 1);
        CHECK(incidents[0].impulse == Approx(momentumOf(world, after, 0).norm()).epsilon(1e-3));
        CHECK(incidents[0].impulse > 1);
    }
}

TEST_CASE("every solver's incidents are the reference's") {
    const double length = GENERATE(0.1, 0.3);  // m, of cells along x: one sphere each, three
    CAPTURE(length);
    const World world(hitHeap(length));
    cpu::ReferenceSolver start(world);
    State state = world.initialState();
    for (int node = 0; node < world.nodeCount(); ++node)
        state.velocity[node] = world.restPosition(node)[1] > 0.3 ? Vec3(1, -2, 6) : Vec3(0, 0, 0);
    start.setState(state);
    std::size_t contacts = 0, breaks = 0;
    for (int snapshot = 0; snapshot < 3; ++snapshot) {
        CAPTURE(snapshot);
        start.advance(40);
        state = roundedToSingle(start.state());
        state.step = kLook - 10;
        const auto found = [&](Solver& solver) {
            IncidentRing ring;
            solver.setIncidents(&ring);
            solver.setState(state);
            solver.advance(10);
            solver.finish();
            return ring.take();
        };
        cpu::ReferenceSolver reference(world);
        const std::vector<Incident> expected = found(reference);
        contacts += expected.size() - breaksOf(expected).size();
        breaks += breaksOf(expected).size();
        for (const SolverUnderTest& under : touchingSolvers()) {
            INFO(under.name);
            const auto solver = under.make(world);
            const std::vector<Incident> actual = found(*solver);
            CHECK(breaksOf(actual) == breaksOf(expected));
            for (const Incident& contact : expected) {
                // Those at the limit may be missing.
                if (contact.kind == Incident::Kind::Break ||
                    contact.impulse < 1.05 * kBlowSpeed * world.cellMass(contact.cell))
                    continue;
                const auto same =
                    std::find_if(actual.begin(), actual.end(), [&](const Incident& other) {
                        return other.kind == contact.kind && other.cell == contact.cell;
                    });
                CAPTURE(contact.cell, contact.impulse);
                REQUIRE(same != actual.end());
                CHECK(same->impulse == Approx(contact.impulse).epsilon(0.01));
                CHECK((same->place - contact.place).norm() < 1e-5);
                // A GPU takes pushes within half an octave for equals.
                CHECK(same->other >= 0);
            }
        }
    }
    CHECK(contacts > 10);
    CHECK(breaks > 10);
}

TEST_CASE("a heap that rests has no incidents", "[long]") {
    WorldDescription d = breakable({3, 4, 2}, FractureMode::None);
    d.materials[0].restitution = 0.2;
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    const World world(d);
    State state = world.initialState();
    for (double& damage : state.damage)
        if (damage != kNoBond) damage = 1;
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        IncidentRing ring;
        const auto solver = under.make(world);
        solver->setIncidents(&ring);
        solver->setState(state);
        solver->advance(9000);
        solver->finish();
        ring.take();
        solver->advance(1500);
        solver->finish();
        CHECK(ring.take().empty());
    }
}

TEST_CASE("watching for incidents changes nothing, and what a state was set to is none") {
    const World world(hitHeap());
    const State state = pulled(world, 8);
    for (const SolverUnderTest& under : touchingSolvers()) {
        if (under.name == "auto") continue;  // who advances what depends on the clock
        INFO(under.name);
        std::uint64_t hashes[2];
        for (const bool watch : {false, true}) {
            IncidentRing ring;
            const auto solver = under.make(world);
            if (watch) solver->setIncidents(&ring);
            solver->setState(state);
            for (const int steps : {7, 100, 40, 30}) solver->advance(steps);
            hashes[watch] = stateHash(solver->state());
            solver->finish();
            CHECK(ring.take().empty() != watch);
            State broken = world.initialState();
            for (double& damage : broken.damage)
                if (damage != kNoBond) damage = 1;
            solver->setState(broken);
            solver->advance(kLook);
            solver->finish();
            CHECK(breaksOf(ring.take()).empty());
            solver->setIncidents(nullptr);
            solver->setState(state);
            solver->advance(3 * kLook);
            solver->finish();
            CHECK(ring.take().empty());
        }
        CHECK(hashes[0] == hashes[1]);
    }
}
