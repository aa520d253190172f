// How a world begins (cpu/settle.hpp).
#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "catch.hpp"
#include "core/standing.hpp"
#include "cpu/settle.hpp"
#include "support/turned_worlds.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

WorldDescription heavy(IVec3 cells) {
    WorldDescription d = block(cells, softElastic());
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    return d;
}

}  // namespace

TEST_CASE("a standing column sags by what its E says") {
    WorldDescription d = heavy({2, 10, 2});
    d.materials[0].poissonRatio = 0;
    d.bodies[0].anchors = {Side::Bottom};
    const World world(d);
    const State state = cpu::settledStart(world).state;
    const double E = world.laws()[0].youngModulus, density = d.materials[0].density;
    const double expected = density * 9.81 * 1 / (2 * E);  // 1 m tall
    double lowest = 0;
    for (const Vec3& u : state.displacement) lowest = std::min(lowest, u[1]);
    // Displacements may still change by 0.2 %; half a per cent of strain bends the straight line.
    CHECK(-lowest == Approx(expected).epsilon(0.02));
    for (const Vec3& v : state.velocity) CHECK(v == Vec3(0, 0, 0));
}

TEST_CASE("what is turned stands on what is turned otherwise") {
    WorldDescription d = heavy({9, 2, 9});
    d.contact = true;
    BodyDescription block = d.bodies[0];
    block.cells = {3, 2, 2};
    block.size = {0.3, 0.2, 0.2};
    const auto groups = [&](const Mat3& slab, const Mat3& top, const Vec3& position) {
        d.bodies[0].orientation = slab;
        block.orientation = top;
        block.position = position;
        d.bodies.resize(1, d.bodies[0]);
        d.bodies.push_back(block);
        const World world(d);
        std::vector<std::vector<int>> bodies;
        for (const StandingGroup& group : standingGroups(world, StandingQuery(world)))
            bodies.push_back(group.bodies);
        return bodies;
    };
    const auto about = [](double angle, const Vec3& axis) {
        return Mat3(Eigen::AngleAxisd(angle, axis).toRotationMatrix());
    };
    const std::vector<std::vector<int>> both = {{0, 1}}, slab = {{0}};
    const Mat3 little = about(0.2, Vec3::UnitY()), more = about(0.7, Vec3::UnitY());
    // With the same axes, with others, upside down, and on its edge; on a slab that is turned.
    CHECK(groups(little, little, {0.1, 0.2, 0}) == both);
    CHECK(groups(little, more, {0.1, 0.2, 0}) == both);
    CHECK(groups(little, more * about(std::numbers::pi, Vec3::UnitZ()), {0.1, 0.4, 0}) == both);
    const double edge = 0.2 + 0.1 * std::sqrt(0.5);
    CHECK(groups(little, more * about(std::numbers::pi / 4, Vec3::UnitX()), {0.1, edge, 0}) ==
          both);
    // In the air above it: half a cell, or a little beside it.
    CHECK(groups(little, more, {0.1, 0.25, 0}) == slab);
    CHECK(groups(little, little, {0.1, 0.25, 0}) == slab);
    CHECK(groups(little, more, {0.8, 0.2, 0}) == slab);
    CHECK(groups(little, little, little * Vec3(0.61, 0.2, 0)) == slab);
    // Beside each other, face to face: neither stands on the other.
    CHECK(groups(little, little, little * Vec3(0.6, 0.05, 0)) == slab);
}

TEST_CASE("a turned wall sags by its weight as an upright one does") {
    WorldDescription d = heavy({4, 9, 2});
    d.ground = false;
    d.bodies[0].anchors = {Side::Bottom};
    const World upright(d);
    const Mat3 turn = Eigen::AngleAxisd(1, Vec3(2, -1, 2) / 3).toRotationMatrix();
    const World world(turnedWorld(d, turn));
    const cpu::Start expected = cpu::settledStart(upright), start = cpu::settledStart(world);
    CHECK(start.restless.empty());
    double lowest = 0;
    for (const Vec3& u : expected.state.displacement) lowest = std::min(lowest, u[1]);
    REQUIRE(lowest < -1e-3);
    // Displacements may still change by 0.2 %.
    CHECK(largestDifference(turnedState(start.state, turn.transpose()).displacement,
                            expected.state.displacement) < -0.004 * lowest);
}

TEST_CASE("bodies that are alike but for their orientation settle each for itself") {
    WorldDescription d = heavy({9, 2, 2});
    d.ground = false;
    d.bodies[0].anchors = {Side::Left};
    BodyDescription other = d.bodies[0];
    other.position = {3, 0, 0};
    other.orientation = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ());
    const auto settled = [&](std::vector<BodyDescription> bodies) {
        d.bodies = std::move(bodies);
        return cpu::settledStart(World(d)).state.displacement;
    };
    const BodyDescription beam = d.bodies[0];
    std::vector<Vec3> alone = settled({beam});
    for (const Vec3& u : settled({other})) alone.push_back(u);
    CHECK(settled({beam, other}) == alone);
}

TEST_CASE("a body in mid-air begins as described") {
    WorldDescription d = heavy({2, 2, 2});
    d.bodies[0].position = {0, 1, 0};
    const World world(d);
    const cpu::Start start = cpu::settledStart(world);
    for (const Vec3& u : start.state.displacement) CHECK(u == Vec3(0, 0, 0));
    CHECK(start.state.slow == world.initialState().slow);
    CHECK(start.restless.empty());
}

TEST_CASE("what sags onto something that falls begins as described, and is named") {
    // A beam of 2 m that sags by 4 cm, and a block in the air 1 cm below it.
    WorldDescription d = heavy({20, 1, 1});
    d.materials[0].youngModulus = 5e6;
    d.bodies[0].name = "beam";
    d.bodies[0].anchors = {Side::Left, Side::Right};
    d.bodies[0].position = {0, 2, 0};
    d.contact = true;
    BodyDescription block = d.bodies[0];
    block.name = "block";
    block.anchors = {};
    block.cells = {1, 1, 1};
    block.size = {0.1, 0.1, 0.1};
    block.position = {0, 1.89, 0};
    d.bodies.push_back(block);
    // With and without an object that holds: bodies that may touch none settle as their likes do.
    for (const bool post : {false, true}) {
        INFO((post ? "with" : "without") << " a post");
        if (post) {
            ObjectDescription object;
            object.name = "post";
            object.halfSize = {0.1, 0.1, 0.1};
            object.mass = 1;
            object.fixed = true;
            object.position = {9, 1, 0};
            d.objects = {object};
        }
        const World world(d);
        const cpu::Start start = cpu::settledStart(world);
        CHECK(start.restless == std::vector<std::string>{"beam"});
        for (const Vec3& u : start.state.displacement) CHECK(u == Vec3(0, 0, 0));
    }
}
