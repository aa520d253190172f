// How a world begins (cpu/settle.hpp).
#include <algorithm>

#include "catch.hpp"
#include "cpu/settle.hpp"
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
