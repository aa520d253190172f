#include "support/display_sections.hpp"

#include <cmath>

#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// From 0 to 1, and often one of the ends.
double extreme(Random& random) {
    const double x = random();
    return x < -0.6 ? 0 : x > 0.6 ? 1 : 0.5 + x / 1.2;
}

}  // namespace

Point point(const surface::DisplayVertex& v) {
    return {v.rest[0], v.rest[1], v.rest[2]};
}

std::vector<surface::DisplayVertex> verticesOf(const World& world) {
    return surface::DisplayMesh(world).vertices();
}

WorldDescription wildWall(int seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Material m;
    const Vec3 cell(0.1 + 0.2 * extreme(random), 0.1 + 0.7 * extreme(random),
                    0.03 + 0.27 * extreme(random));
    m.avgDisplaySectionWidth = cell[0] * (0.5 + extreme(random));
    m.avgDisplaySectionHeight = cell[1] * (0.5 + extreme(random));
    m.randDisplaySectionWidth = m.avgDisplaySectionWidth * extreme(random);
    m.randDisplaySectionHeight = m.avgDisplaySectionHeight * extreme(random);
    // Mostly small ones: twenty points on every edge of every cell take their time.
    const auto frequency = [&] {
        const double x = extreme(random);
        return seed % 20 == 0 ? 20.0 : std::floor(4 * x);
    };
    m.horizEdgeFrequency = frequency();
    m.vertEdgeFrequency = frequency();
    m.horizEdgeAmplitude = 0.5 * m.avgDisplaySectionHeight * extreme(random);
    m.vertEdgeAmplitude = 0.5 * m.avgDisplaySectionWidth * extreme(random);
    m.clusters = static_cast<ClusterKind>(seed % 4);
    m.clusterSize = {2.3 * cell[0], 1.7 * cell[1], seed % 3 == 0 ? 0 : cell[2]};
    m.jointWidth = 0.02 * extreme(random);

    WorldDescription description;
    description.materials = {m};
    BodyDescription body;
    body.name = "wall";
    body.cells = {4, 3, 1 + seed % 2};
    body.size = cell.cwiseProduct(body.cells.cast<double>());
    body.position = {3 * random(), 0.5 + 0.5 * random(), 3 * random()};
    if (seed % 5 == 0) body.regions = {{{1, 1, 0}, {2, 1, 0}, -1}};
    description.bodies = {body};
    description.seed = static_cast<std::uint64_t>(seed);
    return description;
}
