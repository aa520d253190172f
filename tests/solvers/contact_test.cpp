// Contact between cells (core/contact.hpp), on the solvers that have it.
#include "core/contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"
#include "support/touching_worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

void setVelocity(State& state, int cell, const Vec3& velocity) {
    std::fill_n(state.velocity.begin() + kCorners * cell, kCorners, velocity);
}

struct Collision {
    double restitution;
    double momentumError;  ///< kg·m/s
    double mostKinetic;    ///< J at any time after the start, over that at the start
};

/// Two cells at ±2 m/s along x, the line of their paths `offset` apart in y.
Collision collide(const SolverUnderTest& under, double restitution, double offset, double gap) {
    const WorldDescription d = singleCells(
        {{-0.5 * kEdge - gap, 0, 0}, {0.5 * kEdge + gap, offset, 0}}, cellMaterial(restitution, 0));
    const World world(d);
    const auto solver = under.make(world);
    State state = world.initialState();
    setVelocity(state, 0, {2, 0, 0});
    setVelocity(state, 1, {-2, 0, 0});
    solver->setState(state);
    const Diagnostics before = diagnose(world, state);
    Collision result{0, 0, 0};
    for (int i = 0; i < 60; ++i) {
        solver->advance(3);
        const Diagnostics now = diagnose(world, solver->state());
        result.mostKinetic = std::max(result.mostKinetic, now.kinetic / before.kinetic);
        result.momentumError =
            std::max(result.momentumError, (now.momentum - before.momentum).norm());
    }
    // The normal where they touch first: centres one edge apart.
    const Vec3 normal(std::sqrt(kEdge * kEdge - offset * offset) / kEdge, offset / kEdge, 0);
    const State after = solver->state();
    const Vec3 parting = meanOf(after.velocity, 1) - meanOf(after.velocity, 0);
    result.restitution = parting.dot(normal) / (4 * normal[0]);
    return result;
}

Vec3 tiltedGravity(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return 9.81 * Vec3(std::sin(angle), -std::cos(angle), 0);
}

/// A cell on top of an anchored one forty times as large, which is as good as flat: 1.4 cm of way
/// tilt it by 0.4 degrees.
WorldDescription onSlope(double degrees, double friction, double x) {
    WorldDescription d =
        singleCells({{x, std::sqrt(2.05 * 2.05 - x * x) - 2, 0}}, cellMaterial(0.2, friction));
    BodyDescription floor = d.bodies[0];
    floor.size = {4, 4, 4};
    floor.position = {0, -4, 0};
    floor.anchors = {Side::Bottom, Side::Top};
    d.bodies.push_back(floor);
    d.gravity = tiltedGravity(degrees);
    return d;
}

}  // namespace

TEST_CASE("two cells that meet head on part with the restitution asked for") {
    for (const SolverUnderTest& under : touchingSolvers())
        for (const double offset : {0.0, 0.03})
            for (const double restitution : {0.2, 0.5, 0.8}) {
                // Where in a step they first touch matters at 1.3 mm a step: the mean over six.
                double mean = 0;
                for (int phase = 0; phase < 6; ++phase) {
                    const Collision c =
                        collide(under, restitution, offset, 0.03 + phase * 4. / 3000 / 12);
                    mean += c.restitution / 6;
                    // 180 steps, each rounding the 16 nodes' momenta of 0.25 kg·m/s once.
                    CHECK(c.momentumError <= 180 * 16 * 0.25 * under.epsilon);
                    CHECK(c.mostKinetic <= 1 + 200 * under.epsilon);
                }
                INFO(under.name << ", offset " << offset << ", e " << restitution);
                CHECK(mean == Approx(restitution).epsilon(0.1));
            }
}

TEST_CASE("a cell on a slope of 20 degrees holds by a friction of 0.6 but for a creep") {
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const World world(onSlope(20, 0.6, 0));
        const auto solver = under.make(world);
        solver->advance(3000);
        // Friction of β·m/h·v bears the downhill weight m·g·sin at this speed.
        const double creep = world.description().gravity[0] * world.step() / kFrictionRate;
        const double moved = meanOf(solver->state().displacement, 0)[0];
        CHECK(moved > 0);
        CHECK(moved < 1.1 * creep * 1.0);
        CHECK(creep < 0.05 * kEdge);  // a second
    }
}

TEST_CASE("a cell on a slope slides at g(sin − μ·cos)") {
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const double expected =
            9.81 * (std::sin(std::numbers::pi / 9) - 0.2 * std::cos(std::numbers::pi / 9));
        const double time = 0.25, way = 0.5 * expected * time * time;
        const World world(onSlope(20, 0.2, -way / 3));  // level in the mean over the time
        const auto solver = under.make(world);
        solver->advance(750);
        CHECK(meanOf(solver->state().velocity, 0)[0] == Approx(expected * time).epsilon(0.05));
    }
}

TEST_CASE("the ground holds and lets slide like a slope, too") {
    for (const SolverUnderTest& under : touchingSolvers())
        for (const double friction : {0.2, 0.6}) {
            INFO(under.name << ", friction " << friction);
            Material material = softElastic();
            material.youngModulus = 1e8;
            WorldDescription d = block({4, 1, 4}, material);
            d.gravity = tiltedGravity(20);
            d.ground = true;
            d.groundFriction = friction;
            d.contact = true;
            const World world(d);
            const auto solver = under.make(world);
            solver->advance(1500);
            const double expected = d.gravity[0] + friction * d.gravity[1];
            const double speed = diagnose(world, solver->state()).momentum[0] / (64 * 0.25);
            if (expected > 0)
                CHECK(speed == Approx(0.5 * expected).epsilon(0.05));
            else
                CHECK(std::abs(solver->state().displacement[0][0]) < 1e-3 * kEdge);
        }
}

TEST_CASE("bonded neighbours never push: an intact wall moves to the bit as without contact",
          "[long]") {
    WorldDescription d = block({7, 5, 3}, softElastic());
    d.bodies[0].anchors = {Side::Bottom};
    EventDescription event = hit(0, {0, 0.4, 0}, {2, -4, -5});
    d.events = {event};
    const World without(d);
    d.contact = true;
    const World with(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto a = under.make(without), b = under.make(with);
        State state = without.initialState();
        for (int node = 0; node < without.nodeCount(); ++node)
            state.displacement[node] =
                Vec3(-0.2, -0.1, -0.2).cwiseProduct(without.restPosition(node));
        for (Vec3& u : state.displacement) u = u.cast<float>().cast<double>();
        a->setState(state);
        b->setState(state);
        a->advance(600);
        b->advance(600);
        // Without contact compute works block by block, and adds up in another order: 600 times
        // some 1e-7 of what moves by 0.3 m.
        if (under.name == "compute") {
            const State one = a->state(), other = b->state();
            double difference = 0;
            for (int node = 0; node < without.nodeCount(); ++node)
                difference = std::max(difference,
                                      (one.displacement[node] - other.displacement[node]).norm());
            CHECK(difference < 2e-5);
        } else {
            CHECK(stateHash(a->state()) == stateHash(b->state()));
        }
        CHECK(stateHash(a->state()) != stateHash(state));
    }
}

TEST_CASE("a fresh crack does not explode", "[long]") {
    for (const SolverUnderTest& under : touchingSolvers())
        for (const double youngModulus : {1e5, 1e6}) {
            INFO(under.name << ", E " << youngModulus);
            Material material = softElastic();
            material.youngModulus = youngModulus;
            WorldDescription d = block({5, 5, 5}, material);
            d.contact = true;
            const World world(d);
            State state = world.initialState();
            for (int node = 0; node < world.nodeCount(); ++node)
                state.displacement[node] = -0.1 * world.restPosition(node);
            const double stored = diagnose(world, state).elastic;
            breakBonds(state, 1);
            const auto solver = under.make(world);
            solver->setState(state);
            for (int i = 0; i < 100; ++i) {
                solver->advance(15);
                const Diagnostics now = diagnose(world, solver->state());
                REQUIRE(now.kinetic < stored);
            }
            // Neighbours part at a tenth of an edge in kPartingTime at most.
            double fastest = 0;
            const State after = solver->state();
            for (int cell = 0; cell < world.cellCount(); ++cell)
                fastest = std::max(fastest, meanOf(after.velocity, cell).norm());
            CAPTURE(fastest);
            CHECK(fastest < 3 * 0.1 * kEdge / kPartingTime);  // two pairs to the outer cells
        }
}

TEST_CASE("every solver pushes as the reference does", "[long]") {
    const std::vector<SolverUnderTest> solvers = touchingSolvers();
    if (solvers.empty()) return;
    WorldDescription cubes = looseWall();
    // Cells of three and of eight spheres, two materials in one body, and a second body on top.
    WorldDescription bars = looseWall();
    bars.bodies[0].size = {1, 3, 0.2};
    bars.materials.push_back(cellMaterial(0.7, 0.3));
    bars.materials[1].density = 300;
    bars.bodies[0].regions = {{{2, 0, 0}, {5, 7, 1}, 1}};
    BodyDescription slab = bars.bodies[0];
    slab.size = {2, 0.1, 0.8};
    slab.cells = {10, 1, 4};
    slab.position = {0, 3.0, 0};
    slab.regions = {};
    bars.bodies.push_back(slab);
    for (WorldDescription* description : {&cubes, &bars}) {
        const World world(*description);
        description->contact = false;
        const World untouched(*description);
        cpu::ReferenceSolver reference(world), expected(world), without(untouched);
        reference.setState(looseState(world));
        double largest = 0;
        for (int snapshot = 0; snapshot < 4; ++snapshot) {
            reference.advance(401);
            const State before = roundedToSingle(reference.state());
            expected.setState(before);
            without.setState(before);
            expected.advance(1);
            without.advance(1);
            const State after = expected.state(), apart = without.state();
            for (int node = 0; node < world.nodeCount(); ++node)
                largest = std::max(largest, (after.velocity[node] - apart.velocity[node]).norm());
            for (const SolverUnderTest& under : solvers) {
                INFO(under.name << ", snapshot " << snapshot);
                const auto solver = under.make(world);
                solver->setState(before);
                solver->advance(1);
                const State state = solver->state();
                const double worst = largestDifference(state.velocity, after.velocity);
                CAPTURE(worst);
                // Positions of up to 3 m are known to 3ε m. That much of an overlap is κ/h of it in
                // speed; a few pairs to a cell, and the strains of the elements in like measure.
                CHECK(worst < 20 * 3 * 6e-8 / world.step());
            }
        }
        CHECK(largest > 0.05);  // m/s a step: they do push
    }
}

TEST_CASE("whole bodies touch each other and themselves as the reference says") {
    // A hoop whose ends overlap, and two walls, one of long cells, that touch at a corner only.
    WorldDescription d = block({40, 1, 3}, cellMaterial(0.2, 0.6));
    d.bodies.push_back(d.bodies[0]);
    d.bodies[1].size = {1.2, 1.2, 0.1};
    d.bodies[1].cells = {12, 12, 1};
    d.bodies[1].position = {5, 0, 0};
    d.bodies.push_back(d.bodies[1]);
    d.bodies[2].cells = {12, 4, 1};
    d.bodies[2].position = {6, 1.1, 0.1};
    d.contact = true;
    const World world(d);
    State start = world.initialState();
    for (int node = 0; node < world.nodeCount(); ++node) {
        if (world.bodyOf(node / kCorners) == 2) start.displacement[node][2] = -0.02f;
        start.velocity[node] = world.bodyOf(node / kCorners) == 1 ? Vec3(1, 1, 1) : Vec3(0, 0, 0);
        if (world.bodyOf(node / kCorners) != 0) continue;
        const Vec3 rest = world.restPosition(node);
        constexpr double length = 3.95;  // m, once around
        const double radius = length / (2 * std::numbers::pi) + rest[1];
        const double angle = 2 * std::numbers::pi * rest[0] / length;
        const Vec3 bent(radius * std::sin(angle), radius * std::cos(angle), rest[2]);
        start.displacement[node] = (bent - rest).cast<float>().cast<double>();
    }
    cpu::ReferenceSolver expected(world);
    expected.setState(start);
    expected.advance(1);
    d.contact = false;
    const World untouched(d);
    cpu::ReferenceSolver without(untouched);
    without.setState(start);
    without.advance(1);
    const State after = expected.state(), apart = without.state();
    int pushed[3] = {0, 0, 0};
    for (int node = 0; node < world.nodeCount(); ++node)
        if ((after.velocity[node] - apart.velocity[node]).norm() > 1e-3)
            ++pushed[world.bodyOf(node / kCorners)];
    for (int body = 0; body < 3; ++body) {
        CAPTURE(body, pushed[body]);
        CHECK(pushed[body] > 0);
        CHECK(pushed[body] < world.bodies()[body].cellCount());  // of 8 nodes per cell
    }
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->setState(start);
        solver->advance(1);
        const State state = solver->state();
        const double worst = largestDifference(state.velocity, after.velocity);
        CAPTURE(worst);
        CHECK(worst < 20 * 6 * 6e-8 / world.step());  // as above, at up to 6 m
    }
}

TEST_CASE("whatever touches whatever how fast, no number is lost") {
    std::vector<Vec3> places;
    for (int i = 0; i < 300; ++i) places.push_back({0.5 * i, 0.5, 0});
    WorldDescription crowd = singleCells(places, cellMaterial(0.2, 0.6));
    crowd.gravity = {0, -9.81, 0};
    crowd.ground = true;
    WorldDescription inside = block({5, 5, 2}, brittle());
    inside.bodies.push_back(inside.bodies[0]);
    inside.bodies[1].position = {0, 0, 1};
    inside.contact = true;
    WorldDescription fast = inside;
    fast.events = {hit(0, {0, 0.25, 0}, {0, 0, 200})};
    fast.events[0].radius = 1;
    for (const SolverUnderTest& under : touchingSolvers())
        for (const WorldDescription* description : {&crowd, &inside, &fast}) {
            INFO(under.name);
            const World world(*description);
            const auto solver = under.make(world);
            // A world that begins like that is refused: they are put there.
            State state = world.initialState();
            for (int node = 0; node < world.nodeCount(); ++node) {
                const int body = world.bodyOf(node / kCorners);
                if (description == &crowd) state.displacement[node] = Vec3(-0.5 * body, 0, 0);
                if (description == &inside && body == 1)
                    state.displacement[node] = Vec3(0.013f, 0.02f, -1);
            }
            solver->setState(state);
            solver->advance(400);
            const Diagnostics end = diagnose(world, solver->state());
            CHECK(end.nan == 0);
            CHECK(end.maxSpeed > 0);
        }
}
