// How a world begins (cpu/settle.hpp).
#include <algorithm>

#include "catch.hpp"
#include "cpu/settle.hpp"
#include "support/worlds.hpp"

using namespace sunder;

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
    const State state = settledStart(world).state;
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
    const Start start = settledStart(world);
    for (const Vec3& u : start.state.displacement) CHECK(u == Vec3(0, 0, 0));
    CHECK(start.state.slow == world.initialState().slow);
    CHECK(start.restless.empty());
}
