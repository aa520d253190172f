#include "physics/physics_worlds.hpp"

#include "catch.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

WorldDescription elasticBlock(IVec3 cells, double cell, double youngModulus, double poissonRatio) {
    Material material = softElastic();
    material.youngModulus = youngModulus;
    material.poissonRatio = poissonRatio;
    WorldDescription description = block(cells, material);
    description.bodies[0].size = cell * cells.cast<double>();
    return description;
}

void keepAwake(WorldDescription& description) {
    EventDescription nothing;
    nothing.kind = EventDescription::Kind::Force;
    nothing.duration = 1e3;
    nothing.point = {0, description.bodies[0].size[1] / 2, 0};
    nothing.radius = description.bodies[0].size.norm();
    description.events.push_back(nothing);
}

void requireUnlimited(const World& world) {
    for (const ElementLaw& law : world.laws()) REQUIRE_FALSE(law.limited);
}

std::vector<SolverUnderTest> allSolvers() {
    std::vector<SolverUnderTest> all = cpuSolvers();
    for (SolverUnderTest& under : gpuSolvers())
        if (under.name != "auto") all.push_back(std::move(under));
    return all;
}

Vec3 latticePosition(const World& world, int node) {
    const int cell = node / kCorners;
    const Body& body = world.bodies()[world.bodyOf(cell)];
    return body.origin + body.coordinates(cell).cast<double>().cwiseProduct(body.cellSize) +
           world.cornerOffset(cell, node % kCorners);
}
