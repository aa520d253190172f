// How `gather` leaves sleeping bodies out of its passes.
#include "catch.hpp"
#include "gpu/gather.hpp"
#include "gpu/test_context.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("rectangles cover a range of texels once each, in order") {
    constexpr int columns = 64;
    for (const gpu::TexelRange range : {gpu::TexelRange{0, 1},
                                        {0, 64},
                                        {0, 640},
                                        {5, 6},
                                        {5, 64},
                                        {5, 65},
                                        {63, 129},
                                        {60, 300},
                                        {128, 200},
                                        {7, 7}}) {
        INFO(range.first << " .. " << range.end);
        const auto rectangles = gpu::rectanglesOf(range, columns);
        CHECK(rectangles.size() <= 3);
        int next = range.first;
        for (const auto& [x0, y0, x1, y1] : rectangles)
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x) CHECK(columns * y + x == next++);
        CHECK(next == range.end);
    }
}

TEST_CASE("a world asleep runs no pass, one body awake runs them all") {
    testContext();
    WorldDescription d = block({3, 2, 1}, brittle());
    d.bodies.push_back(d.bodies[0]);
    d.events = {hit(1, {0, 0.1, 0}, {0, 0, -1})};
    d.events[0].time = 1;
    const World world(d);
    const gpu::WorldBuffers buffers(world);
    gpu::GatherSolver solver(world, buffers);
    solver.advance(2900);  // nothing pulls: asleep after 0.5 s
    REQUIRE(solver.asleep(0));
    REQUIRE(solver.asleep(1));
    gpu::PassTimer timer(testContext().info().software);
    solver.setPassTimer(&timer);
    solver.advance(100);
    CHECK(timer.take().empty());
    solver.advance(100);
    CHECK(solver.asleep(0));
    CHECK(!solver.asleep(1));
    CHECK(timer.take().size() == 6);  // elements, stresses, bonds, nodes, links, rest
}
