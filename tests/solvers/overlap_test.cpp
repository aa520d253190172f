// What overlaps from the start, or comes to by a throw, parts gently (core/overlap.hpp), on the
// solvers with contact.
#include "core/overlap.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/object_contact.hpp"
#include "cpu/reference.hpp"
#include "support/solver_under_test.hpp"
#include "support/touching_worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Nothing pulls; everything may overlap.
WorldDescription emptyWorld() {
    WorldDescription d = block({1, 1, 1}, softElastic());
    d.bodies.clear();
    d.contact = true;
    return d;
}

void add(WorldDescription& d, const IVec3& cells, const Vec3& position) {
    BodyDescription& body = d.bodies.emplace_back();
    body.name = "body " + std::to_string(d.bodies.size());
    body.cells = cells;
    body.size = kEdge * cells.cast<double>();
    body.position = position;
    body.mayOverlap = true;
}

void add(WorldDescription& d, ObjectShape shape, const Vec3& halfSize, double mass,
         const Vec3& position) {
    ObjectDescription& object = d.objects.emplace_back();
    object.name = "object " + std::to_string(d.objects.size());
    object.shape = shape;
    object.halfSize = halfSize;
    object.mass = mass;
    object.position = position;
    object.drag = 0;
    object.mayOverlap = true;
}

/// Of each body, then of each object that is not fixed: its mass, kg, kinetic energy, J, and
/// velocity, m/s.
struct Motion {
    double mass = 0, energy = 0;
    Vec3 velocity{0, 0, 0};
};
std::vector<Motion> motions(const World& world, const State& state) {
    std::vector<Motion> result(world.bodies().size());
    for (int node = 0; node < world.nodeCount(); ++node) {
        Motion& of = result[static_cast<std::size_t>(world.bodyOf(node / kCorners))];
        const double mass = world.nodeMass(node);
        of.mass += mass;
        of.energy += 0.5 * mass * state.velocity[node].squaredNorm();
        of.velocity += mass * state.velocity[node];
    }
    for (Motion& of : result) of.velocity /= of.mass;
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        const Object& object = world.objects()[i];
        if (object.inverseMass == 0 || !state.objects[i].present) continue;
        result.push_back({1 / object.inverseMass, state.objects[i].kineticEnergy(object),
                          state.objects[i].velocity});
    }
    return result;
}

/// Advances, and checks all the while that nothing has more energy than what moves at the parting
/// speed. Returns the last state.
State checkGentle(const World& world, Solver& solver, int steps) {
    const double speed = world.description().partingSpeed;
    double most = 0;
    State state;
    for (int done = 0; done < steps; done += 25) {
        solver.advance(25);
        state = solver.state();
        for (const Motion& of : motions(world, state))
            most = std::max(most, of.energy / (0.5 * of.mass * speed * speed));
    }
    CAPTURE(most);
    CHECK(most <= 1);
    CHECK(most > 0);
    return state;
}

/// m: by how much spheres of a pair of bodies overlap, at most.
double overlapOf(const World& world, const State& state, int bodyA, int bodyB) {
    const auto centresOf = [&](int index) {
        std::vector<Vec3> centres;
        const Body& body = world.bodies()[index];
        for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
            Vec3 rest = Vec3::Zero();
            for (int corner = 0; corner < kCorners; ++corner)
                rest += world.restPosition(kCorners * cell + corner) / kCorners;
            centres.push_back(rest + meanOf(state.displacement, cell));
        }
        return centres;
    };
    double deepest = 0;
    for (const Vec3& a : centresOf(bodyA))
        for (const Vec3& b : centresOf(bodyB)) deepest = std::max(deepest, kEdge - (a - b).norm());
    return deepest;
}

/// m: of the lowest node of a body.
double lowest(const World& world, const State& state, int index) {
    double y = 1e9;
    const Body& body = world.bodies()[index];
    for (int node = kCorners * body.firstCell;
         node < kCorners * (body.firstCell + body.cellCount()); ++node)
        y = std::min(y, world.restPosition(node)[1] + state.displacement[node][1]);
    return y;
}

/// Pairs of bodies, far from each other: by 5, 50, 100 and 250 % of a cell in each other, wholly,
/// and a small one inside a large one.
WorldDescription bodiesInBodies() {
    WorldDescription d = emptyWorld();
    const double depths[] = {0.05, 0.5, 1, 2.5};
    for (int i = 0; i < 4; ++i) {
        add(d, {4, 3, 3}, {3. * i, 0, 0});
        add(d, {4, 3, 3}, {3. * i + (4 - depths[i]) * kEdge, 0, 0});
    }
    for (int i = 0; i < 2; ++i) add(d, {1, 1, 1}, {0, 0, 3});
    add(d, {5, 5, 5}, {3, 0, 3});
    add(d, {2, 2, 2}, {3.113, 0.17, 3.02});
    return d;
}

}  // namespace

TEST_CASE("bodies that are in each other part, at no more than the parting speed", "[long]") {
    for (const double speed : {1.0, 0.25}) {
        WorldDescription d = bodiesInBodies();
        d.partingSpeed = speed;
        // The second pair alone shows that the speed counts.
        if (speed != 1) d.bodies = {d.bodies[2], d.bodies[3]};
        const World world(d);
        REQUIRE(2 * world.partings().size() == d.bodies.size());
        for (const SolverUnderTest& under : contactSolvers()) {
            INFO(under.name << ", " << speed << " m/s");
            const auto solver = under.make(world);
            // The way out is 0.3 m at most, or 0.05 m, at 0.4 times the speed and somewhat slower
            // at first.
            const State state = checkGentle(world, *solver, speed == 1 ? 3000 : 2000);
            const std::vector<Motion> end = motions(world, state);
            Vec3 momentum = Vec3::Zero();
            double scale = 0;
            for (std::size_t i = 0; i < end.size(); i += 2) {
                CAPTURE(i);
                CHECK(overlapOf(world, state, static_cast<int>(i), static_cast<int>(i) + 1) <
                      1e-3 * kEdge);
                const double parting = (end[i].velocity - end[i + 1].velocity).norm();
                CHECK(parting <= speed);
                CHECK(parting > 0.2 * speed);
                for (const std::size_t side : {i, i + 1}) {
                    momentum += end[side].mass * end[side].velocity;
                    scale += end[side].mass * end[side].velocity.norm();
                }
            }
            // Rounding of forces of some 100 N over the steps of a contact.
            CHECK(momentum.norm() < 1e4 * under.epsilon * scale);
        }
    }
}

TEST_CASE("bodies below the ground or outside the room come back at the parting speed at most",
          "[long]") {
    WorldDescription d = emptyWorld();
    add(d, {4, 3, 2}, {0, -0.07, 0});
    add(d, {4, 3, 2}, {2, -0.6, 0});
    add(d, {2, 2, 2}, {4.95, 0.5, 0});
    add(d, {2, 2, 2}, {0, 4.1, 0});
    d.ground = true;
    d.room = RoomDescription{{-5, 5}, {-5, 5}, 0.5, 4.0};
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        const State state = checkGentle(world, *solver, 5400);
        const std::vector<Motion> end = motions(world, state);
        for (const int body : {0, 1}) {
            CHECK(lowest(world, state, body) > -1e-6);
            CHECK(end[body].velocity[1] > 0.1);
        }
        CHECK(end[2].velocity[0] < -0.1);
        CHECK(end[3].velocity[1] < -0.1);
        for (const Motion& of : end) CHECK(of.velocity.norm() <= 1);
    }
}

TEST_CASE("a body below the ground comes up and rests, whatever its weight") {
    Material material = softElastic();
    material.damping = 2;
    WorldDescription d = block({3, 3, 2}, material);
    d.bodies[0].position = {0, -0.15, 0};
    d.bodies[0].mayOverlap = true;
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(6000);
        const State state = solver->state();
        CHECK(std::abs(lowest(world, state, 0)) < 1e-3);
        // Its weight presses it by ρ·g·H²/2E, less than a millimetre.
        CHECK(meanOf(state.displacement, 13)[1] == Approx(0.15).margin(2e-3));
        CHECK(diagnose(world, state).maxSpeed < 0.05);
    }
}

TEST_CASE("objects that are in the ground, a wall or each other part gently", "[long]") {
    WorldDescription d = emptyWorld();
    d.ground = true;
    d.room = RoomDescription{{-5, 5}, {-5, 5}, 0.5, 4.0};
    // Below the ground and outside the room.
    add(d, ObjectShape::Sphere, {0.1, 0.1, 0.1}, 1, {0, -0.2, 0});
    add(d, ObjectShape::Box, {0.2, 0.1, 0.3}, 5, {2, -0.1, 0});
    d.objects.back().orientation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized());
    add(d, ObjectShape::Capsule, {0.1, 0.2, 0.1}, 1, {5.1, 2, 0});
    // In each other: balls, a cube in a slab, two slabs, all of them in the same place or nearly.
    for (const double offset : {0.0, 0.02}) {
        add(d, ObjectShape::Sphere, {0.1, 0.1, 0.1}, 1, {-2, 2, 0});
        add(d, ObjectShape::Sphere, {0.1, 0.1, 0.1}, 1, {-2 + offset, 2, 0});
        add(d, ObjectShape::Box, {0.2, 0.1, 0.3}, 5, {-3.5, 2, 0});
        add(d, ObjectShape::Box, {0.1, 0.1, 0.1}, 1, {-3.5 + offset, 2.03, 0.01});
        d.objects.back().orientation = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized());
        add(d, ObjectShape::Box, {0.2, 0.1, 0.3}, 5, {-3.5, 0.5, 0});
        add(d, ObjectShape::Box, {0.2, 0.1, 0.3}, 5, {-3.5 + 5 * offset, 0.5, 0});
        for (std::size_t i = d.objects.size() - 6; i < d.objects.size(); ++i)
            d.objects[i].position->z() += offset > 0 ? 3 : 0;
    }
    // In a wall, heavy and light, and in the middle of a block.
    add(d, {7, 5, 1}, {0, 1, 3});
    add(d, {7, 5, 1}, {2, 1, 3});
    add(d, {5, 5, 5}, {0, 1, -3});
    add(d, ObjectShape::Sphere, {0.15, 0.15, 0.15}, 50, {0.03, 1.22, 3});
    add(d, ObjectShape::Box, {0.1, 0.1, 0.1}, 0.5, {2.03, 1.22, 3.04});
    add(d, ObjectShape::Sphere, {0.12, 0.12, 0.12}, 2, {0.03, 1.23, -2.99});
    const World world(d);
    for (const SolverUnderTest& under : contactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        const State state = checkGentle(world, *solver, 3600);
        for (const ObjectState& object : state.objects) CHECK(object.velocity.norm() <= 1);
        const auto box = [&](std::size_t i) { return boxOf(world.objects()[i], state.objects[i]); };
        const auto position = [&](std::size_t i) { return state.objects[i].position; };
        CHECK(position(0)[1] > 0.1);
        CHECK(position(1)[1] > 0.1);
        CHECK(position(2)[0] < 4.9);
        for (std::size_t i = 3; i < 15; i += 2) {
            CAPTURE(i);
            CHECK(touchOf(box(i), box(i + 1)).gap > -1e-3);
        }
        CHECK(std::abs(position(15)[2] - 3) > 0.2);
        CHECK(std::abs(position(16)[2] - 3) > 0.2);
        CHECK((position(17) - Vec3(0.03, 1.23, -2.99)).norm() > 0.3);
    }
}

TEST_CASE("what is thrown into a wall or below the ground parts gently, too") {
    WorldDescription d = emptyWorld();
    d.ground = true;
    add(d, {7, 5, 1}, {0, 0.5, 0});
    d.bodies[0].mayOverlap = false;
    add(d, ObjectShape::Sphere, {0.15, 0.15, 0.15}, 5, {0, 0, 0});
    add(d, ObjectShape::Sphere, {0.15, 0.15, 0.15}, 5, {0, 0, 0});
    for (ObjectDescription& object : d.objects) {
        object.position.reset();
        object.mayOverlap = false;
    }
    d.throws = {{0.02, 0, {0.03, 0.72, 0.01}, {0, 0, 0}, {0, 0, 0}},
                {0.02, 1, {3, -1, 0}, {0, 0, 0}, {0, 0, 0}}};
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        const State state = checkGentle(world, *solver, 2400);
        CHECK(std::abs(state.objects[0].position[2]) > 0.2);
        CHECK(state.objects[1].velocity[1] == Approx(world.pushSpeed()).epsilon(0.01));
    }
}

TEST_CASE("a fixed object in a wall pushes the wall away") {
    WorldDescription d = emptyWorld();
    add(d, {7, 5, 1}, {0, 0.5, 0});
    add(d, ObjectShape::Box, {0.15, 0.15, 0.15}, 1, {0.03, 0.72, 0.12});
    d.objects[0].fixed = true;
    const World world(d);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        const std::vector<Motion> end = motions(world, checkGentle(world, *solver, 1500));
        CHECK(end[0].velocity[2] < -0.1);
        CHECK(end[0].velocity.norm() <= 1);
    }
}

TEST_CASE("what parts does so as the reference says") {
    WorldDescription d = bodiesInBodies();
    d.materials[0].friction = 0.5;
    add(d, {4, 3, 2}, {0, -0.13, -3});
    add(d, {7, 5, 1}, {3, 0.1, -3});
    add(d, ObjectShape::Sphere, {0.15, 0.15, 0.15}, 5, {3.03, 0.31, -2.99});
    add(d, ObjectShape::Box, {0.15, 0.15, 0.15}, 5, {5, 0.11, -3});
    add(d, ObjectShape::Box, {0.1, 0.1, 0.1}, 1, {5.05, 0.15, -3.02});
    // Cells of three spheres, in cubes.
    add(d, {3, 2, 3}, {6, 0, -3});
    d.bodies.back().size = {0.3, 0.6, 0.3};
    add(d, {3, 3, 3}, {6.17, 0.11, -3});
    d.ground = true;
    d.gravity = {0, -9.81, 0};
    const World world(d);
    cpu::ReferenceSolver reference(world);
    for (int snapshot = 0; snapshot < 4; ++snapshot) {
        const State before = roundedToSingle(reference.state());
        cpu::ReferenceSolver expected(world);
        expected.setState(before);
        expected.advance(1);
        const State after = expected.state();
        CHECK(largestDifference(before.velocity, after.velocity) > 1e-3);
        for (const SolverUnderTest& under : touchingSolvers()) {
            INFO(under.name << ", snapshot " << snapshot);
            const auto solver = under.make(world);
            solver->setState(before);
            solver->advance(1);
            const State state = solver->state();
            const double worst = largestDifference(state.velocity, after.velocity);
            CAPTURE(worst);
            // Places of up to 9.4 m are known to 9.4 ε; as in "every solver pushes as the
            // reference does".
            const double bound = 20 * 9.4 * 6e-8 / world.step();
            CHECK(worst < bound);
            for (std::size_t i = 0; i < state.objects.size(); ++i)
                CHECK((state.objects[i].velocity - after.objects[i].velocity).norm() < bound);
        }
        reference.advance(37);
    }
}
