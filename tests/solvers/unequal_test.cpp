// Heavy bodies on light ones (core/contact.hpp: the force of constraint).
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/incident.hpp"
#include "cpu/settle.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Two blocks of 3 x 3 x 3 cells, one on the other; as stiff as the step carries, unbreakable.
WorldDescription twoBlocks(double ratio) {
    Material material = softElastic();
    material.youngModulus = 1e12;
    material.density = 100;
    WorldDescription d = block({3, 3, 3}, material);
    material.density *= ratio;
    d.materials.push_back(material);
    BodyDescription upper = d.bodies[0];
    upper.name = "upper";
    upper.material = 1;
    upper.position = {0, 0.3, 0};
    d.bodies.push_back(upper);
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    return d;
}

/// m, mean place of the nodes of a body's top or bottom face.
Vec3 faceOf(const World& world, const State& state, int body, bool top) {
    const Body& of = world.bodies()[body];
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (int cell = of.firstCell; cell < of.firstCell + of.cellCount(); ++cell)
        for (int corner = 0; corner < kCorners; ++corner) {
            if (of.coordinates(cell)[1] != (top ? 2 : 0) || (corner >> 1 & 1) != top) continue;
            const int node = kCorners * cell + corner;
            sum += world.restPosition(node) + state.displacement[node];
            ++count;
        }
    return sum / count;
}

}  // namespace

TEST_CASE("a heavy body stands on a light one for ten seconds, to a thousand times its mass",
          "[long]") {
    for (const double ratio : {30.0, 1000.0}) {
        const World world(twoBlocks(ratio));
        REQUIRE(world.unequalCells());
        const cpu::Start start = cpu::settledStart(world);
        REQUIRE(start.restless.empty());
        for (const SolverUnderTest& under : contactSolvers()) {
            INFO(under.name << ", 1 : " << ratio);
            const auto solver = under.make(world);
            solver->setState(start.state);
            solver->advance(ratio > 30 ? 30000 : 6000);
            const State state = solver->state();
            const Vec3 lower = faceOf(world, state, 0, true),
                       upper = faceOf(world, state, 1, false);
            // 5 % of a cell. (Its corners are bent up where they overhang, by 2.8 % at 1 : 1000.)
            CHECK(std::abs(lower[1] - upper[1]) < 0.05 * 0.1);
            // Nothing holds them but friction. In single precision, awake, rounding adds up.
            CHECK(std::hypot(upper[0], upper[2]) < 0.01 * 0.1);
            if (!under.sleeps) continue;
            CHECK(solver->asleep(0));
            CHECK(solver->asleep(1));
        }
    }
}

TEST_CASE("what carries a heavy body takes no momentum from the two") {
    WorldDescription d = twoBlocks(100);
    d.gravity.setZero();
    d.ground = false;
    const World world(d);
    State start = world.initialState();
    const Body& upper = world.bodies()[1];
    const int first = kCorners * upper.firstCell, end = first + kCorners * upper.cellCount();
    for (int node = first; node < end; ++node) start.velocity[node] = {0.5, -2, 0};
    const Diagnostics before = diagnose(world, start);
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->setState(start);
        double most = 0;
        for (int i = 0; i < 30; ++i) {
            solver->advance(20);
            const Diagnostics now = diagnose(world, solver->state());
            most = std::max(most, now.kinetic + now.elastic);
            // Forces come in pairs, equal to the bit; what is left is rounding of 600 steps' sums.
            CHECK((now.momentum - before.momentum).norm() <
                  600 * under.epsilon * before.momentum.norm());
        }
        // Nor does it give energy: a spring that is found pressed in has an error of first order in
        // the step, here of a few per cent.
        CHECK(most < 1.05 * before.kinetic);
    }
}

TEST_CASE("cells that cannot move push each other with no force of constraint") {
    WorldDescription d = twoBlocks(100);
    d.ground = false;
    d.gravity.setZero();
    for (BodyDescription& body : d.bodies) {
        body.cells = {1, 1, 1};
        body.size = {0.1, 0.1, 0.1};
        body.anchors = {Side::Left, Side::Right};
    }
    d.bodies[1].position = {0, 0.0996, 0};  // in the lower one by less than is refused
    BodyDescription thrown = d.bodies[0];
    thrown.name = "thrown";
    thrown.anchors = {};
    thrown.position = {0.12, 0, 0};
    d.bodies.push_back(thrown);
    const World world(d);
    State start = world.initialState();
    for (int node = 2 * kCorners; node < 3 * kCorners; ++node) start.velocity[node] = {-5, 0, 0};
    for (const SolverUnderTest& under : touchingSolvers()) {
        INFO(under.name);
        IncidentRing ring;
        const auto solver = under.make(world);
        solver->setIncidents(&ring);
        solver->setState(start);
        // Solvers on a GPU hand incidents over two looks late.
        for (int look = 0; look < 5; ++look) {
            solver->advance(50);
            solver->finish();
        }
        // Neither is pushed by a number that is none: then no blow to it would be heard.
        const std::vector<Incident> incidents = ring.take();
        const auto hit = [&](const Incident& incident) {
            return incident.kind == Incident::Kind::Contact && incident.cell == 0;
        };
        const auto found = std::find_if(incidents.begin(), incidents.end(), hit);
        REQUIRE(found != incidents.end());
        CHECK(std::isfinite(found->impulse));
        CHECK(diagnose(world, solver->state()).nan == 0);
    }
}
