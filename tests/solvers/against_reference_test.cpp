// Every solver against the reference, on walls whose counts are multiples of nothing.
#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A 7×5×3 wall beside a smaller one of another material and cell size, standing on the ground, hit
/// from the front.
WorldDescription oddWalls(const Material& first, const Material& second) {
    WorldDescription d = block({7, 5, 3}, first);
    d.materials.push_back(second);
    BodyDescription other = d.bodies[0];
    other.name = "other";
    other.cells = {3, 4, 1};
    other.size = {0.36, 0.6, 0.1};
    other.position = {1.5, 0, 0.2};
    other.material = 1;
    other.regions = {{{1, 1, 0}, {1, 2, 0}, -1}, {{0, 3, 0}, {2, 3, 0}, 0}};
    d.bodies.push_back(other);
    for (BodyDescription& body : d.bodies) body.anchors = {Side::Bottom};
    d.gravity = {0.3, -9.81, 0};
    d.ground = true;
    for (const int body : {0, 1}) {
        EventDescription hit;
        hit.kind = EventDescription::Kind::Velocity;
        hit.body = body;
        hit.point = {0.05, 0.35, 0.1};
        hit.radius = 0.17;
        hit.vector = {0.5, -1, -6};
        d.events.push_back(hit);
    }
    return d;
}

std::vector<int> brokenBonds(const State& state) {
    std::vector<int> broken;
    for (std::size_t bond = 0; bond < state.damage.size(); ++bond)
        if (state.damage[bond] >= 1) broken.push_back(static_cast<int>(bond));
    return broken;
}

}  // namespace

TEST_CASE("positions agree with the reference after 100 steps of an unbroken impact") {
    for (const ConstitutiveLaw law : {ConstitutiveLaw::Green, ConstitutiveLaw::Corotated}) {
        Material first = softElastic(), second = softElastic();
        first.law = law;
        second.law = law;
        second.youngModulus = 1e8;  // limited by the step
        second.damping = 2;
        second.density = 600;
        const World world(oddWalls(first, second));
        REQUIRE(world.laws()[1].limited);
        cpu::ReferenceSolver reference(world);
        reference.advance(100);
        const State expected = reference.state();
        REQUIRE(largestDifference(expected.displacement, world.initialState().displacement) >
                0.03);  // it was hit
        for (const SolverUnderTest& under : solversUnderTest()) {
            INFO(under.name << ", " << toString(law));
            const auto solver = under.make(world);
            solver->advance(60);
            solver->advance(40);
            const State state = solver->state();
            const double difference = largestDifference(state.displacement, expected.displacement);
            CAPTURE(difference);
            CHECK(difference < 1e-4 * 0.1);  // of the smallest cell edge
            CHECK(largestDifference(state.velocity, expected.velocity) < 1e-4 * 6);
        }
    }
}

TEST_CASE("strongly deformed soft elements agree with the reference") {
    for (const ConstitutiveLaw law : {ConstitutiveLaw::Green, ConstitutiveLaw::Corotated}) {
        Material material = softElastic();
        material.law = law;
        material.youngModulus = 1e4;
        WorldDescription description = oddWalls(material, material);
        description.events.clear();
        description.gravity.setZero();
        description.ground = false;
        const World world(description);
        for (const ElementLaw& soft : world.laws()) REQUIRE(soft.hotViscosity > 0);
        // |F|² is 7.6 everywhere, and nothing is near to flat: there two rotations are as good.
        State start = world.initialState();
        for (int node = 0; node < world.nodeCount(); ++node) {
            if (!world.present(node / kCorners)) continue;
            const Vec3 x = world.restPosition(node);
            start.displacement[node] =
                Vec3(1.2 * x[0], 0.3 * x[1], 0.2 * x[0]).cast<float>().cast<double>();
            start.velocity[node] =
                Vec3(20 * std::sin(9 * x[1]), 20 * std::cos(7 * x[2]), 20 * std::sin(8 * x[0]))
                    .cast<float>()
                    .cast<double>();
        }
        cpu::ReferenceSolver reference(world);
        reference.setState(start);
        reference.advance(20);
        const State expected = reference.state();
        for (const SolverUnderTest& under : solversUnderTest()) {
            INFO(under.name << ", " << toString(law));
            const auto solver = under.make(world);
            solver->setState(start);
            solver->advance(20);
            const State state = solver->state();
            // As in the test above: 1e-4 of the start's largest speed.
            CHECK(largestDifference(state.velocity, expected.velocity) < 1e-4 * 20);
            CHECK(largestDifference(start.velocity, state.velocity) > 1);
        }
    }
}

TEST_CASE("from the same snapshot, one step breaks the same bonds", "[long]") {
    for (const FractureMode mode : {FractureMode::Bond, FractureMode::Cell}) {
        Material first = brittle(), second = brittle();
        first.fracture = second.fracture = mode;
        first.maxStress = second.maxStress = 8e4;
        second.youngModulus = 1e8;
        second.strength = second.boundaryStrength = {3e5, 1e5, 1e5};
        WorldDescription description = oddWalls(first, second);
        description.fractureInterval = 1;
        const World world(description);
        cpu::ReferenceSolver reference(world);
        const std::vector<SolverUnderTest> under = solversUnderTest();
        std::vector<std::unique_ptr<Solver>> solvers;
        for (const SolverUnderTest& each : under) solvers.push_back(each.make(world));
        std::size_t broke = 0, snapshots = 0;
        for (int step = 0; step < 300; ++step) {
            const State before = reference.state();
            reference.advance(1);
            const State after = reference.state();
            const bool news = brokenBonds(before) != brokenBonds(after);
            if (!news && step % 50 != 0) continue;
            broke += brokenBonds(after).size() - brokenBonds(before).size();
            ++snapshots;
            for (std::size_t i = 0; i < under.size(); ++i) {
                INFO(under[i].name << ", " << toString(mode) << ", step " << step);
                solvers[i]->setState(before);
                solvers[i]->advance(1);
                const State state = solvers[i]->state();
                CHECK(brokenBonds(state) == brokenBonds(after));
                for (std::size_t bond = 0; bond < after.damage.size(); ++bond) {
                    CHECK(state.damage[bond] == Approx(after.damage[bond]).margin(1e-4));
                    CHECK(state.slow[bond] == Approx(after.slow[bond]).margin(10));  // Pa, of 1e5
                }
            }
        }
        CHECK(broke > 20);
        CHECK(snapshots > 5);
    }
}

TEST_CASE("a state read back and set again goes on as if nothing had happened") {
    const World world(oddWalls(brittle(), brittle()));
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto through = under.make(world), first = under.make(world),
                   second = under.make(world);
        through->advance(90);
        first->advance(37);
        second->setState(first->state());
        second->advance(53);
        CHECK(stateHash(second->state()) == stateHash(through->state()));
        CHECK(second->state().damage == through->state().damage);
        CHECK(diagnose(world, second->state()).bondsBroken > 0);
    }
}
