// The solver `compute`: gather's passes as compute shaders.
#include <algorithm>

#include "catch.hpp"
#include "gpu/guest.hpp"
#include "gpu/test_context.hpp"
#include "scene/scene.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// After so many steps, both have the same numbers. A driver may round what is smaller than the
/// smallest normal number to zero in one stage and not in the other (llvmpipe does): 1e-30 is that
/// and what becomes of it.
void checkSame(const World& world, int steps) {
    const gpu::WorldBuffers buffers(world);
    gpu::GatherSolver gather(world, buffers);
    gpu::ComputeSolver compute(world, buffers);
    CHECK(compute.name() == "compute");
    for (int done = 0; done < steps; done += 17) {
        gather.advance(17);
        compute.advance(17);
    }
    const State a = gather.state(), b = compute.state();
    testContext().check();
    CHECK(a.damage == b.damage);
    double difference = 0;
    for (int node = 0; node < world.nodeCount(); ++node)
        difference = std::max({difference, (a.displacement[node] - b.displacement[node]).norm(),
                               (a.velocity[node] - b.velocity[node]).norm()});
    for (std::size_t i = 0; i < a.objects.size(); ++i)
        difference = std::max(difference, (a.objects[i].position - b.objects[i].position).norm());
    CHECK(difference < 1e-30);
}

/// Most compilers round fragments and invocations in ways of their own; llvmpipe's does not.
/// Elsewhere tests/solvers says that both are right.
bool sameRounding() {
    return testContext().info().renderer.find("llvmpipe") != std::string::npos;
}

}  // namespace

TEST_CASE("compute has gather's numbers: walls of any size, while they break") {
    if (!sameRounding()) return;
    // One cell; one layer that is longer than a group; sizes that no group divides; several bodies.
    for (const IVec3& cells :
         {IVec3(1, 1, 1), IVec3(301, 1, 1), IVec3(1, 1, 65), IVec3(7, 9, 3), IVec3(64, 2, 1)}) {
        INFO(cells.transpose());
        WorldDescription d = block(cells, brittle());
        d.bodies[0].anchors = {Side::Left};
        d.gravity = {0, -9.81, 0};
        d.ground = true;
        BodyDescription other = d.bodies[0];
        other.name = "other";
        other.position += Vec3(0, 2, 0);
        d.bodies.push_back(other);
        d.events = {hit(1, {0, 0.05, 0}, {0, 6, 5})};
        d.events[0].radius = 1;
        checkSame(World(d), 170);
    }
}

TEST_CASE("compute has gather's numbers: contact, objects, both kinds of fracture") {
    if (!sameRounding()) return;
    checkSame(guestWorld(), 170);
    for (const char* name : {"wood-thesis", "brick"}) {
        INFO(name);
        scene::Scene scene = scene::loadScene(name);
        checkSame(World(scene.world), 85);
    }
}
