// Looking at a world on a GPU without waiting for it, and worlds there that grow: sunder/gl.hpp.
#include <cmath>

#include "gpu/library_host.hpp"

using namespace sunder;
using namespace library_host;

namespace {

/// s, of a frame of whole substeps.
constexpr double kSteps = 50. / 3000;

double heightOfBall(const World& world) {
    const Result<ObjectState> ball = world.object(0);
    REQUIRE(ball);
    return ball->transform.position.z;
}

}  // namespace

TEST_CASE("library: on a GPU a world is looked at two steps late, and nothing waits") {
    Host host;
    gl::Device device(host.options());
    for (const std::string_view solver : {"gather", "scatter", "auto"}) {
        INFO(solver);
        // m: `auto` gives bodies to whoever was faster, and each rounds its own way.
        const double tolerance = solver == "auto" ? 1e-5 : 0;
        World world = made(wallAndBall(), {.device = &device, .solver = solver});
        std::vector<double> flown{heightOfBall(world)};  // at each step, by an equal world
        World equal = made(wallAndBall(), {.device = &device, .solver = solver});
        constexpr int kFrames = 8;
        for (int i = 0; i < kFrames; ++i) {
            REQUIRE(equal.step(kSteps));
            REQUIRE(equal.finish());
            CHECK(equal.lookTime() == equal.time());
            flown.push_back(heightOfBall(equal));
        }
        CHECK(world.lookTime() == 0);
        const std::size_t memory = device.memory();
        REQUIRE(world.step(kSteps));
        CHECK(device.memory() == memory);               // nobody has looked while it was under way
        CHECK(world.castRay({0, 0.3, 2}, {0, 0, -1}));  // the first look waits
        CHECK(world.lookTime() == world.time());
        for (int i = 2; i <= kFrames; ++i) {
            const int seen = std::max(1, i - 2);
            const ReadCounter counter(device.impl().driver->functions());
            REQUIRE(world.step(kSteps));
            // `auto` measures now and then who is faster, for which it waits.
            (void)ReadCounter::takeWaits();
            CHECK(std::lround(world.lookTime() / kSteps) == seen);
            CHECK(std::abs(heightOfBall(world) - flown[static_cast<std::size_t>(seen)]) <=
                  tolerance);
            CHECK(world.pieces());
            CHECK(world.brokenBonds());
            CHECK(ReadCounter::takeWaits() == 0);
        }
        REQUIRE(world.finish());
        CHECK(world.lookTime() == world.time());
        CHECK(std::abs(heightOfBall(world) - flown.back()) <= tolerance);
        CHECK(*world.brokenBonds() > 0);
    }
}

TEST_CASE("library: on a GPU a world goes on in a larger one from where it was") {
    Host host;
    gl::Device device(host.options());
    for (const std::string_view solver : {"gather", "scatter", "auto"}) {
        INFO(solver);
        WorldDesc desc = wallAndBall();
        World world = made(desc, {.device = &device, .solver = solver});
        for (int i = 0; i < 4; ++i) REQUIRE(world.step(kFrame));
        REQUIRE(world.finish());
        const int broken = *world.brokenBonds();
        CHECK(broken > 0);
        const double height = heightOfBall(world);
        const WorldSize before = world.size();

        desc.addMaterial(Material::preset("rubber"));
        desc.addBody(
            {.material = 2, .size = {0.2, 0.2, 0.2}, .cells = {2, 2, 2}, .position = {-1, 0.5, 0}});
        desc.addObject(Object::box({0.2, 0.2, 0.2}).at({-1, 1, 0}));
        host.unnoticed("extend", [&] { REQUIRE(world.extend(desc)); });
        CHECK(world.size().cells == before.cells + 8);
        CHECK(*world.brokenBonds() == broken);
        CHECK(heightOfBall(world) == height);
        CHECK(world.time() > 0.06);
        const auto below = world.castRay({-1, 3, 0}, {0, -1, 0});
        REQUIRE(below);
        CHECK(below->object == 1);
        CHECK_THAT(world.notes().back(), Catch::StartsWith("the world was extended once"));
        for (int i = 0; i < 30; ++i) REQUIRE(world.step(kFrame));
        REQUIRE(world.finish());
        CHECK(world.castRay({-1, 3, 0}, {0, -1, 0})->place.y < 0.9);  // from 1.1
        CHECK(*world.brokenBonds() >= broken);

        // What fails changes nothing.
        const std::uint64_t hash = *world.stateHash();
        WorldDesc fewer = desc;
        fewer.bodies.pop_back();
        CHECK(world.extend(fewer).error().message ==
              "extend: the description has 2 bodies, the world 3; it takes the world's own with "
              "more at the ends");
        WorldDesc wrong = desc;
        wrong.addBody({.material = 7});
        CHECK_FALSE(world.extend(wrong));
        CHECK(*world.stateHash() == hash);
        REQUIRE(world.step(kFrame));
    }
    CHECK(device.memory() == 0);
}
