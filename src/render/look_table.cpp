#include "render/look_table.hpp"

#include <algorithm>
#include <vector>

#include "gpu/layout.hpp"

namespace sunder::render {

using namespace core;

namespace {

constexpr int kBinding = 1;
/// m. A wall of solid wood is glued from boards of this width: one piece of 3 m by 2 m grows on no
/// tree.
constexpr double kBoardWidth = 0.2;
constexpr double kGlueWidth = 0.001;  ///< m

static_assert(static_cast<int>(SurfaceKind::Plain) == SUNDER_SURFACE_PLAIN &&
              static_cast<int>(SurfaceKind::Wood) == SUNDER_SURFACE_WOOD &&
              static_cast<int>(SurfaceKind::Brick) == SUNDER_SURFACE_BRICK &&
              static_cast<int>(SurfaceKind::Concrete) == SUNDER_SURFACE_CONCRETE &&
              static_cast<int>(SurfaceKind::Rubber) == SUNDER_SURFACE_RUBBER &&
              static_cast<int>(SurfaceKind::Glass) == SUNDER_SURFACE_GLASS);

gpu::SurfaceLook lookOf(const Material& material) {
    int clusters = SUNDER_CLUSTERS_NONE;
    Vec3 size = material.clusterSize;
    double joint = material.jointWidth;
    if (material.clusters == ClusterKind::RunningBond) clusters = SUNDER_CLUSTERS_RUNNING_BOND;
    if (material.clusters == ClusterKind::Planks) {
        clusters = SUNDER_CLUSTERS_PLANKS;
        size[1] = size[2] = 0;
    } else if (material.surface == SurfaceKind::Wood) {
        clusters = SUNDER_CLUSTERS_BOARDS;
        size = {kBoardWidth, 0, 0};
        joint = kGlueWidth;
    }
    return {.outside = gpu::toVec4(material.colour, 0),
            .inside = gpu::toVec4(material.insideColour, 0),
            .clusters = gpu::toVec4(size, clusters),
            .finish = gpu::toVec4(
                {static_cast<double>(material.surface), joint, material.transparency}, 0)};
}

gl::Buffer makeLooks(const World& world) {
    std::vector<gpu::SurfaceLook> looks(SUNDER_MAX_ELEMENT_LAWS);
    for (std::size_t i = 0; i < world.laws().size(); ++i)
        looks[i] = lookOf(world.description().materials[world.laws()[i].material]);
    return gl::makeBuffer<gpu::SurfaceLook>(looks, GL_STATIC_DRAW, "looks of materials");
}

bool hasTransparent(const World& world) {
    return std::any_of(world.laws().begin(), world.laws().end(), [&](const ElementLaw& law) {
        return world.description().materials[law.material].transparency > 0;
    });
}

}  // namespace

LookTable::LookTable(const World& world)
    : buffer_(makeLooks(world)), anyTransparent_(hasTransparent(world)) {}

void LookTable::prepare(const gl::Program& program) {
    program.bindUniformBlock("SurfaceLooks", kBinding);
}

void LookTable::bind() const {
    gl::bindUniforms(kBinding, buffer_);
}

}  // namespace sunder::render
