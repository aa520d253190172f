// Where the mesh that is seen is when its wall bends, breaks and flies: no seams, no torn sections.
#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "catch.hpp"
#include "support/display_sections.hpp"
#include "support/turned_worlds.hpp"
#include "support/worlds.hpp"
#include "surface/display_mesh.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A wall with wild sections, bent and stretched; and some of its bonds broken.
struct BentWall {
    World world;
    State state;
    explicit BentWall(int seed) : world(wildWall(seed)), state(world.initialState()) {
        for (int node = 0; node < world.nodeCount(); ++node) {
            const Vec3 x = world.restPosition(node);
            state.displacement[node] = {0.05 * std::sin(3 * x[1]), 0.1 * x[0] * x[1],
                                        0.2 * std::sin(2 * x[0])};
        }
    }
};

}  // namespace

TEST_CASE("an intact wall has no seams when it bends", "[display]") {
    for (const int seed : {1, 2, 3, 5, 6, 7}) {
        CAPTURE(seed);
        const BentWall wall(seed);
        std::map<Point, Vec3> places;
        for (const surface::DisplayVertex& v : verticesOf(wall.world)) {
            const Vec3 place = surface::displayedPosition(wall.world, wall.state, v);
            const auto [known, isNew] = places.emplace(point(v), place);
            if (!isNew) REQUIRE(known->second == place);  // to the bit
        }
    }
}

TEST_CASE("a turned wall has no seams, and its torn faces are its twin's, turned", "[display]") {
    Random random(5);
    for (const int seed : {1, 2, 5, 7}) {
        CAPTURE(seed);
        const BentWall twin(seed);
        const Mat3 turn = random.rotation();
        WorldDescription d = turnedWorld(twin.world.description(), turn);
        d.ground = false;
        const World world(d);
        for (const double share : {0.0, 0.5}) {
            State expected = twin.state;
            for (double& damage : expected.damage)
                if (damage < 1 && random() < 2 * share - 1) damage = 1;
            const State state = turnedState(expected, turn);
            std::map<Point, Vec3> places;
            const auto vertices = verticesOf(world), others = verticesOf(twin.world);
            REQUIRE(vertices.size() == others.size());
            double most = 0;
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                const Vec3 place = surface::displayedPosition(world, state, vertices[i]);
                const Vec3 other = surface::displayedPosition(twin.world, expected, others[i]);
                most = std::max(most, (place - turn * other).norm());
                if (share > 0) continue;
                const auto [known, isNew] = places.emplace(point(vertices[i]), place);
                if (!isNew) REQUIRE(known->second == place);  // to the bit
            }
            // Places at rest are single-precision numbers, of some metres.
            CHECK(most < 2e-6);
        }
    }
}

TEST_CASE("sections that still hang together around a point share it, others leave it",
          "[display]") {
    Random random(11);
    for (const int seed : {1, 2, 5, 7}) {
        CAPTURE(seed);
        BentWall wall(seed);
        const World& world = wall.world;
        for (double& damage : wall.state.damage)
            if (damage < 1 && random() > 0) damage = 1;
        std::map<std::pair<Point, int>, Vec3> places;
        for (const surface::DisplayVertex& v : verticesOf(world))
            places[{point(v), static_cast<int>(v.cell)}] =
                surface::displayedPosition(world, wall.state, v);
        int joined = 0, apart = 0;
        for (const auto& [key, place] : places) {
            const auto& [p, cell] = key;
            for (int axis = 0; axis < 3; ++axis) {
                const int next = world.neighbour(cell, axis, +1);
                const auto other = places.find({p, next});
                if (next < 0 || other == places.end()) continue;
                if (wall.state.damage[kBondsPerCell * cell + axis] < 1) {
                    ++joined;
                    REQUIRE(other->second == place);
                } else {
                    apart += other->second != place;
                }
            }
        }
        CHECK(joined > 20);
        CHECK(apart > 20);
    }
}

TEST_CASE("a section that has come loose moves as one body, whole", "[display]") {
    for (const int seed : {1, 2, 7}) {
        CAPTURE(seed);
        const World world(wildWall(seed));
        State state = world.initialState();
        const int cell = world.bodies()[0].cellAt({1, 1, 0});
        detach(world, state, cell);
        const surface::DisplayMesh mesh(world);
        const State before = state;
        const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
        const Vec3 by(0.3, -0.2, 0.7);
        for (int corner = 0; corner < kCorners; ++corner) {
            const int node = kCorners * cell + corner;
            const Vec3 x = world.restPosition(node);
            state.displacement[node] = turn * x + by - x;
        }
        for (const surface::DisplayVertex& v : mesh.vertices()) {
            const Vec3 then = surface::displayedPosition(world, before, v);
            const Vec3 now = surface::displayedPosition(world, state, v);
            if (static_cast<int>(v.cell) == cell)
                // Rest positions of nodes are rounded to single precision.
                REQUIRE((now - (turn * then + by)).norm() < 1e-6);
            else
                REQUIRE(now == then);
        }
    }
}
