// What is in each other at the end of a run, and said (core/sunk.hpp).
#include "core/sunk.hpp"

#include "catch.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Two blocks of 2 x 2 x 2 cells of 0.1 m, and a ball beside them.
WorldDescription twoBlocksAndABall() {
    WorldDescription d = block({2, 2, 2}, softElastic());
    d.bodies[0].name = "lower";
    BodyDescription upper = d.bodies[0];
    upper.name = "upper";
    upper.position = {0, 0.2, 0};
    d.bodies.push_back(upper);
    ObjectDescription ball;
    ball.name = "ball";
    ball.shape = ObjectShape::Sphere;
    ball.halfSize = {0.1, 0.1, 0.1};
    ball.mass = 1;
    ball.position = {1, 0.1, 0};
    d.objects.push_back(ball);
    d.contact = true;
    return d;
}

void move(const World& world, State& state, int body, const Vec3& way) {
    const int first = kCorners * world.bodies()[body].firstCell;
    for (int node = first; node < first + kCorners * world.bodies()[body].cellCount(); ++node)
        state.displacement[node] += way;
}

}  // namespace

TEST_CASE("things that touch are not sunk, nor those that press each other in a little") {
    const World world(twoBlocksAndABall());
    State state = world.initialState();
    CHECK(sunkThings(world, state).empty());
    CHECK(sunkNote({}).empty());
    move(world, state, 1, {0, -0.04, 0});  // less than half a cell
    CHECK(sunkThings(world, state).empty());
}

TEST_CASE("a body more than half a cell in another one is named with it, and how deep it is") {
    const World world(twoBlocksAndABall());
    State state = world.initialState();
    move(world, state, 1, {0, -0.06, 0});
    const std::vector<Sunk> sunk = sunkThings(world, state);
    REQUIRE(sunk.size() == 1);
    CHECK(sunk[0].a == "lower");
    CHECK(sunk[0].b == "upper");
    CHECK(sunk[0].depth == Approx(0.06));
    CHECK(sunkNote(sunk).find("'lower' and 'upper' are in each other by 0.06 m") == 0);
}

TEST_CASE("an object that has the middle of a cell within it is named with the body") {
    const World world(twoBlocksAndABall());
    State state = world.initialState();
    state.objects[0].position = {0.1, 0.1, 0};
    const std::vector<Sunk> sunk = sunkThings(world, state);
    REQUIRE(sunk.size() == 1);
    CHECK(sunk[0].a == "lower");
    CHECK(sunk[0].b == "ball");
}

TEST_CASE("where nothing touches, nothing is sunk") {
    WorldDescription d = twoBlocksAndABall();
    d.contact = false;
    d.objects.clear();
    const World world(d);
    State state = world.initialState();
    move(world, state, 1, {0, -0.06, 0});
    CHECK(sunkThings(world, state).empty());
}
