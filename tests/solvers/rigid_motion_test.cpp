// What no elastic body may do by itself: move from rest, resist rotation, change its momentum.
#include <Eigen/Geometry>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

double largest(const std::vector<Vec3>& field) {
    double result = 0;
    for (const Vec3& v : field) result = std::max(result, v.lpNorm<Eigen::Infinity>());
    return result;
}

}  // namespace

TEST_CASE("an unloaded wall at rest does not change by a bit") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const World world(block({7, 5, 3}, brittle()));
        const auto solver = under.make(world);
        solver->advance(1000);
        const State state = solver->state();
        CHECK(largest(state.displacement) == 0);
        CHECK(largest(state.velocity) == 0);
        CHECK(state.damage == world.initialState().damage);
        CHECK(state.step == 1000);
    }
}

TEST_CASE("a standing wall settles under its weight and stays", "[long]") {
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        Material material = brittle();
        material.damping = 20;
        WorldDescription description = block({4, 5, 2}, material);
        description.gravity = {0, -9.81, 0};
        description.ground = true;
        description.bodies[0].anchors = {Side::Bottom};
        const World world(description);
        const auto solver = under.make(world);
        solver->advance(6000);
        const State settled = solver->state();
        solver->advance(1000);
        const State later = solver->state();
        // ρgL²/2E of a column, less where the anchored base keeps it from widening.
        const double sag = 1000 * 9.81 * 0.5 * 0.5 / (2 * 1e6);
        double top = 0, moved = 0;
        for (int node = 0; node < world.nodeCount(); ++node) {
            top = std::min(top, later.displacement[node][1]);
            moved = std::max(moved, (later.displacement[node] - settled.displacement[node]).norm());
        }
        CHECK(top < -0.75 * sag);
        CHECK(top > -1.05 * sag);
        // 1e-6 of a cell: rounding of the forces (E·ε) against the stiffness moves a node by about
        // ε·ℓ.
        CHECK(moved < 1e-6 * 0.1);
        CHECK(diagnose(world, later).bondsBroken == 0);
    }
}

TEST_CASE("a rotated and translated wall feels no force") {
    for (const SolverUnderTest& under : solversUnderTest())
        for (const ConstitutiveLaw law : {ConstitutiveLaw::Green, ConstitutiveLaw::Corotated}) {
            INFO(under.name << ", " << toString(law));
            Material material = softElastic();
            material.law = law;
            const World world(block({7, 5, 3}, material));
            const auto solver = under.make(world);
            Random random(3);
            for (int trial = 0; trial < 8; ++trial) {
                const Mat3 R = trial == 0 ? Mat3(Vec3(-1, -1, 1).asDiagonal()) : random.rotation();
                const Vec3 shift = random.vector();
                State state = world.initialState();
                for (int node = 0; node < world.nodeCount(); ++node) {
                    // Not restPosition(): its rounding is a strain, too.
                    const int cell = node / kCorners;
                    const Body& body = world.bodies()[0];
                    const Vec3 x =
                        body.coordinates(cell).cast<double>().cwiseProduct(body.cellSize) +
                        world.cornerOffset(cell, node % kCorners);
                    state.displacement[node] = R * x + shift - x;
                }
                solver->setState(state);
                solver->advance(1);
                // Rounding of positions (up to 2.5 m here) is a strain of 2.5 ε/ℓ; E times that
                // over ρℓ is an acceleration.
                const double rounding =
                    2.5 * under.epsilon / 0.1 * 1e6 / (1000 * 0.1) * world.step();
                CHECK(largest(solver->state().velocity) < 20 * rounding);
            }
        }
}

TEST_CASE("linear and angular momentum are kept without gravity and anchors") {
    for (const SolverUnderTest& under : solversUnderTest())
        for (const ConstitutiveLaw law : {ConstitutiveLaw::Green, ConstitutiveLaw::Corotated}) {
            INFO(under.name << ", " << toString(law));
            Material material = softElastic();
            material.law = law;
            const World world(block({7, 5, 3}, material));
            const auto solver = under.make(world);
            // A spin, a drift, and a smooth wobble that strains the block by several per cent.
            State state = world.initialState();
            for (int node = 0; node < world.nodeCount(); ++node) {
                const Vec3 x = world.restPosition(node);
                state.velocity[node] =
                    Vec3(0.5, 0.2, -0.3) + Vec3(1, 2, -1.5).cross(x) +
                    0.4 * Vec3(std::sin(9 * x[1]), std::cos(7 * x[2]), std::sin(8 * x[0]));
            }
            solver->setState(state);
            const Diagnostics before = diagnose(world, solver->state());
            solver->advance(1000);
            const Diagnostics after = diagnose(world, solver->state());
            double scale = 0;
            for (int node = 0; node < world.nodeCount(); ++node)
                scale += world.nodeMass(node) * state.velocity[node].norm();
            // 1000 steps, each rounding every node's velocity once.
            CHECK((after.momentum - before.momentum).norm() < 1000 * under.epsilon * scale);
            // Damping is taken from where the nodes will be b·h later, which slows a spin of ω by
            // b·h·ω² a second: with ω = 2.7 8e-5 in this third of a second, were all of it rigid.
            CHECK((after.angularMomentum - before.angularMomentum).norm() <
                  1e-4 * before.angularMomentum.norm());
            CHECK(after.kinetic + after.elastic < before.kinetic + before.elastic);
            CHECK(after.elastic > 0.001 * before.kinetic);  // it did wobble
        }
}
