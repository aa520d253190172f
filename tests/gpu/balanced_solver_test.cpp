// `auto`: bodies move between `cpu` and `gather` with their state intact.
#include "balance/balanced_solver.hpp"

#include <numeric>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "gpu/test_context.hpp"
#include "render/renderer.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Three walls, breaking.
WorldDescription breakingWalls() {
    WorldDescription d = block({7, 5, 1}, brittle());
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    for (int i = 1; i < 3; ++i) {
        d.bodies.push_back(d.bodies[0]);
        d.bodies[i].position = {2. * i, 0, 0};
        d.bodies[i].cells = {5 + i, 6, 1 + i};
        d.bodies[i].size = 0.1 * d.bodies[i].cells.cast<double>();
    }
    for (int i = 0; i < 3; ++i) d.events.push_back(hit(i, {0, 0.3, 0}, {2, 0, -15}));
    return d;
}

void checkSame(const State& a, const State& b) {
    CHECK(a.step == b.step);
    CHECK(a.displacement == b.displacement);
    CHECK(a.velocity == b.velocity);
    CHECK(a.damage == b.damage);
    CHECK(a.slow == b.slow);
}

/// Moves every body from `first` to `second` and back while it breaks, one after the other, and
/// goes on: to the bit as if it had stayed.
void checkRoundTrip(const World& world, Solver& first, Solver& second, Solver& stays) {
    auto &host = dynamic_cast<BodyHost&>(first), &other = dynamic_cast<BodyHost&>(second);
    State scratch = world.initialState();
    const int bodies = static_cast<int>(world.bodies().size());
    std::vector<int> all(world.bodies().size());
    std::iota(all.begin(), all.end(), 0);
    other.release(all, scratch);
    int broken = 0;
    for (int round = 0; round < 6; ++round) {
        first.advance(17);  // now and then between two fracture updates
        second.advance(17);
        stays.advance(17);
        const State before = first.state();
        const Diagnostics diagnostics = diagnose(world, before);
        if (round < 4) CHECK(diagnostics.bondsBroken > broken);
        broken = diagnostics.bondsBroken;
        const int body = round % bodies;
        scratch.step = before.step;
        host.release({body}, scratch);
        CHECK(!host.holds(body));
        other.adopt({body}, scratch);
        CHECK(other.holds(body));
        scratch = world.initialState();
        scratch.step = before.step;
        other.release({body}, scratch);
        host.adopt({body}, scratch);
        checkSame(first.state(), before);
    }
    checkSame(first.state(), stays.state());
}

}  // namespace

TEST_CASE("a body that moves there and back while it breaks is the same to the bit") {
    testContext();
    const World world(breakingWalls());
    const gpu::WorldBuffers buffers(world);
    {
        INFO("cpu, gather, cpu");
        cpu::CpuSolver cpu(world, 2), stays(world, 1);
        gpu::GatherSolver gather(world, buffers);
        checkRoundTrip(world, cpu, gather, stays);
    }
    {
        INFO("gather, cpu, gather");
        cpu::CpuSolver cpu(world, 2);
        gpu::GatherSolver gather(world, buffers), stays(world, buffers);
        checkRoundTrip(world, gather, cpu, stays);
    }
    testContext().check();
}

TEST_CASE("a solver leaves a body it does not hold alone") {
    testContext();
    const World world(breakingWalls());
    const gpu::WorldBuffers buffers(world);
    cpu::CpuSolver cpu(world);
    gpu::GatherSolver gather(world, buffers);
    State fromCpu = world.initialState(), fromGather = fromCpu;
    gather.release({0, 2}, fromGather);
    cpu.release({1}, fromCpu);
    cpu.advance(60);
    gather.advance(60);
    const State parts[] = {cpu.state(), gather.state(), cpu.state()};
    cpu::CpuSolver all(world);
    all.advance(60);
    const State expected = all.state();
    for (int index = 0; index < 3; ++index) {
        const Body& body = world.bodies()[index];
        double largest = 0;
        for (int node = kCorners * body.firstCell;
             node < kCorners * (body.firstCell + body.cellCount()); ++node) {
            // gather rounds otherwise than cpu: 60 steps, displacements up to 0.3 m.
            CHECK((parts[index].displacement[node] - expected.displacement[node]).norm() < 1e-3);
            largest = std::max(largest, expected.displacement[node].norm());
        }
        CHECK(largest > 0.05);
    }
}

TEST_CASE("auto finds its share, keeps it, and draws what the CPU holds") {
    testContext();
    const World world(breakingWalls());
    const gpu::WorldBuffers buffers(world);
    balance::BalancedSolver solver(world, buffers);
    for (int frame = 0; frame < 200 && !solver.settled(); ++frame) solver.advance(4);
    REQUIRE(solver.settled());
    const State state = solver.state();
    CHECK(diagnose(world, state).bondsBroken > 20);
    CHECK(diagnose(world, state).nan == 0);
    render::Renderer renderer(world, buffers);
    gpu::StateUpload upload(world);
    scene::CameraDescription camera;
    camera.position = {2, 1, 6};
    camera.target = {2, 0.3, 0};
    const render::RenderSettings small{.width = 320, .height = 180};
    const image::Image drawn = renderer.draw(solver.view(), camera, small);
    const image::Image expected = renderer.draw(upload.upload(state), camera, small);
    CHECK(drawn.pixels == expected.pixels);
    testContext().check();
}
