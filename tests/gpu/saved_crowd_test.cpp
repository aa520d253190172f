// Saved states of crowds, in which the GPU's search for contacts leaves some out.
#include <algorithm>

#include "catch.hpp"
#include "core/saved_state.hpp"
#include "gpu/gather.hpp"
#include "gpu/scatter.hpp"
#include "gpu/test_context.hpp"
#include "support/touching_worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

constexpr int kCells = 60;

WorldDescription apart() {
    std::vector<Vec3> places;
    for (int i = 0; i < kCells; ++i) places.push_back({0.3 * i, 1, 0});
    return singleCells(places, cellMaterial(0.5, 0.3));
}

/// All of them within a voxel of the search, or about to be, which has room for twelve; some of
/// them faster than it follows.
State crowded(const World& world) {
    State state = world.initialState();
    state.step = 44;  // soon `gather` looks
    Random random(3);
    for (int cell = 0; cell < kCells; ++cell) {
        const Vec3 to = 0.1 * random.vector(), v = (cell % 3 == 0 ? 90 : 2) * random.vector();
        for (int corner = 0; corner < kCorners; ++corner) {
            const int node = kCorners * cell + corner;
            state.displacement[node] = (Vec3(-0.3 * cell, 0, 0) + to).cast<float>().cast<double>();
            state.velocity[node] = v;
        }
    }
    return state;
}

template <class Solver>
void checkCrowd() {
    constexpr int kSteps = 30, kFurther = 7;
    const World world(apart());
    testContext();
    const gpu::WorldBuffers buffers(world);
    Solver solver(world, buffers);
    solver.setState(crowded(world));
    std::vector<std::vector<std::byte>> saved;
    for (int i = 0; i <= kSteps + kFurther; ++i) {
        if (i > 0) solver.advance(1);
        saved.push_back(saveState(world, solver));
    }
    Solver other(world, buffers);
    for (int i = 0; i <= kSteps; ++i) {
        const int step = 23 * i % (kSteps + 1);
        CAPTURE(step);
        restoreState(world, other, saved[step]);
        REQUIRE((saveState(world, other) == saved[step]));
        for (int k = 0; k < kFurther; ++k) {
            other.advance(1);
            other.finish();  // scatter counts what it left out in the searches before one
        }
        REQUIRE((saveState(world, other) == saved[step + kFurther]));
    }
    Solver fresh(world, buffers);
    restoreState(world, fresh, saved.back());
    for (Solver* each : {&solver, &fresh}) {
        each->advance(200);
        each->finish();
    }
    CHECK(solver.droppedContacts() > 0);
    CHECK(fresh.droppedContacts() == solver.droppedContacts());
    const std::vector<double> haste = solver.contactHaste();
    CHECK(*std::max_element(haste.begin(), haste.end()) > 1);
    CHECK(fresh.contactHaste() == solver.contactHaste());
    Solver late(world, buffers);  // which no crowd is to come of
    restoreState(world, late, saveState(world, solver));
    CHECK(late.droppedContacts() == solver.droppedContacts());
    CHECK(late.contactHaste() == solver.contactHaste());
    testContext().check();
}

}  // namespace

TEST_CASE("a crowd that has left contacts out goes on from a saved state to the bit") {
    SECTION("gather") {
        checkCrowd<gpu::GatherSolver>();
    }
    SECTION("scatter") {
        checkCrowd<gpu::ScatterSolver>();
    }
}
