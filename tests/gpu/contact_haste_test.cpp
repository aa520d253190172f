// Contacts that are too fast for the search on the GPU are said to be.
#include "catch.hpp"
#include "gpu/gather.hpp"
#include "gpu/scatter.hpp"
#include "gpu/test_context.hpp"
#include "support/touching_worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// GpuSolver::contactHaste() after two cells of 0.1 m flew past a third, at rest.
template <class Solver>
std::vector<double> hasteAt(double speed) {
    const World world(
        singleCells({{-0.3, 0, 0}, {-0.41, 0, 0}, {0, 0.12, 0}}, cellMaterial(0.5, 0)));
    testContext();
    const gpu::WorldBuffers buffers(world);
    Solver solver(world, buffers);
    State state = world.initialState();
    for (int node = 0; node < 2 * kCorners; ++node) state.velocity[node] = {speed, 0, 0};
    solver.setState(state);
    // `gather` knows three looks later.
    for (int step = 0; step < 200; step += 4) {
        solver.advance(4);
        solver.finish();
    }
    testContext().check();
    return solver.contactHaste();
}

template <class Solver>
void checkHaste() {
    // A search every 4/3000 s sees what is 0.15 m apart at most, and needs 0.1 m for the radii:
    // cells that close in by more than 0.05 m, a tenth on top, come too fast.
    for (const double speed : {20.0, 100.0}) {
        const std::vector<double> haste = hasteAt<Solver>(speed);
        REQUIRE(haste.size() == 3);
        const double times = 1.1 * speed * 4 / 3000 / 0.05;
        for (const int body : {0, 2}) {
            // In quarter octaves, rounded up.
            CHECK(haste[body] >= std::max(1.0, times * 0.99));
            CHECK(haste[body] <= std::max(1.0, times * 1.2));
        }
    }
}

}  // namespace

TEST_CASE("GPU solvers say when cells met too fast for their search") {
    SECTION("gather") {
        checkHaste<gpu::GatherSolver>();
    }
    SECTION("scatter") {
        checkHaste<gpu::ScatterSolver>();
    }
}
