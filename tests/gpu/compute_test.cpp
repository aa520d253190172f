// The solver `compute`: gather's passes as compute shaders, and blocks of cells for several
// substeps.
#include <algorithm>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "gpu/block_plan.hpp"
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

/// A wall that is hit and breaks, and another above it that does not.
World walls(const IVec3& cells, bool contact) {
    WorldDescription d = block(cells, brittle());
    d.bodies[0].anchors = {Side::Left};
    d.gravity = {0, -9.81, 0};
    d.ground = true;
    d.contact = contact;
    BodyDescription other = d.bodies[0];
    other.name = "other";
    other.position += Vec3(0, 2, 0);
    d.bodies.push_back(other);
    d.events = {hit(1, {0, 0.05, 0}, {0, 6, 5})};
    d.events[0].radius = 1;
    return World(d);
}

// One cell; one layer that is longer than a group; sizes that no group divides.
const std::vector<IVec3> kSizes{{1, 1, 1}, {301, 1, 1}, {1, 1, 65},
                                {7, 9, 3}, {64, 2, 1},  {23, 17, 2}};

TEST_CASE("compute has gather's numbers: walls of any size, while they break") {
    if (!sameRounding()) return;
    for (const IVec3& cells : kSizes) {
        INFO(cells.transpose());
        checkSame(walls(cells, true), 170);
    }
}

TEST_CASE("every cell of a body is owned by one block, with its rim around it") {
    for (const IVec3& cells : kSizes) {
        INFO(cells.transpose());
        const World world = walls(cells, false);
        const gpu::BlockPlan plan(world, 64);
        CHECK(plan.whole(1) == (cells.prod() <= 64));
        std::vector<int> owners(static_cast<std::size_t>(cells.prod()));
        for (const gpu::BlockRecord& block : plan.blocksOf(1)) {
            CHECK(block.origin.w == 1);
            CHECK(block.size.x * block.size.y * block.size.z <= plan.cells());
            for (int axis = 0; axis < 3; ++axis) {
                const int first = block.origin[axis] + block.first[axis],
                          end = block.origin[axis] + block.end[axis],
                          high = block.origin[axis] + block.size[axis];
                CHECK(block.first[axis] == std::min(plan.kRim, first));
                CHECK(high - end == std::min(plan.kRim, cells[axis] - end));
            }
            for (int z = block.first.z; z < block.end.z; ++z)
                for (int y = block.first.y; y < block.end.y; ++y)
                    for (int x = block.first.x; x < block.end.x; ++x)
                        ++owners[(block.origin.x + x) +
                                 cells[0] *
                                     ((block.origin.y + y) + cells[1] * (block.origin.z + z))];
        }
        // Three cells thick is too thick for blocks of 64: even one cell with its rim has 75.
        CHECK((plan.cells() <= 64) == (cells[2] < 3 || cells[2] == 65));
        CHECK((plan.work() == gpu::BlockPlan::kNoRoom) == (plan.cells() > 64));
        CHECK(std::all_of(owners.begin(), owners.end(), [](int n) { return n == 1; }));
    }
}

TEST_CASE("blocks and passes break a wall alike, and copies of a node stay equal to the bit") {
    testContext();
    for (const IVec3& cells : kSizes) {
        INFO(cells.transpose());
        const World world = walls(cells, false);
        const gpu::WorldBuffers buffers(world);
        gpu::GatherSolver gather(world, buffers);
        gpu::ComputeSolver compute(world, buffers), again(world, buffers);
        // Not by a multiple of the substeps that go by at once.
        for (int i = 0; i < 5; ++i) {
            gather.advance(7);
            compute.advance(7);
        }
        again.advance(35);
        const State a = gather.state(), b = compute.state(), c = again.state();
        testContext().check();
        CHECK(b.displacement == c.displacement);
        CHECK(b.damage == c.damage);
        double difference = 0, moved = 0;
        int broken = 0, otherwise = 0;
        for (int node = 0; node < world.nodeCount(); ++node) {
            moved = std::max(moved, a.displacement[node].norm());
            difference = std::max(difference, (a.displacement[node] - b.displacement[node]).norm());
        }
        for (std::size_t bond = 0; bond < a.damage.size(); ++bond) {
            broken += a.damage[bond] == 1;
            otherwise += (a.damage[bond] == 1) != (b.damage[bond] == 1);
        }
        CHECK(moved > 0.01);
        CHECK((broken > 0 || cells.prod() == 1));
        // Sums in another order: some 1e-7 of every stress, which grows where pieces part.
        CHECK(difference < 1e-4 * moved);
        CHECK(otherwise == 0);
        CHECK(tornNodes(world, b) == 0);
    }
}

TEST_CASE("compute has gather's numbers: contact, objects, both kinds of fracture") {
    if (!sameRounding()) return;
    checkSame(guestWorld(), 170);
    for (const char* name : {"wood-thesis", "brick"}) {
        INFO(name);
        scene::Scene scene = scene::loadScene(name);
        scene.world.contact = true;  // or blocks do what passes do for gather
        checkSame(World(scene.world), 85);
    }
}
