#include "view/picker.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sunder::view {

using namespace core;

namespace {

/// Distance along the ray at which it enters a triangle's plane inside the triangle, from either
/// side (Möller and Trumbore 1997); none where it passes by.
std::optional<double> meetTriangle(const Vec3& origin, const Vec3& direction, const Vec3& a,
                                   const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a;
    const Vec3 p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (std::abs(determinant) < 1e-14) return std::nullopt;
    const Vec3 t = origin - a;
    const double u = t.dot(p) / determinant;
    if (u < 0 || u > 1) return std::nullopt;
    const Vec3 q = t.cross(ab);
    const double v = direction.dot(q) / determinant;
    if (v < 0 || u + v > 1) return std::nullopt;
    const double distance = ac.dot(q) / determinant;
    return distance > 0 ? std::optional(distance) : std::nullopt;
}

std::optional<double> meetSphere(const Vec3& origin, const Vec3& direction, const Vec3& centre,
                                 double radius) {
    const Vec3 to = centre - origin;
    const double along = to.dot(direction);
    const double inside = radius * radius - (to - along * direction).squaredNorm();
    if (inside < 0) return std::nullopt;
    const double distance = along - std::sqrt(inside);
    return distance > 0 ? std::optional(distance) : std::nullopt;
}

/// A box around the origin.
std::optional<double> meetBox(const Vec3& origin, const Vec3& direction, const Vec3& half) {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (-half[axis] - origin[axis]) / direction[axis];
        const double b = (half[axis] - origin[axis]) / direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter > 0 && enter <= leave ? std::optional(enter) : std::nullopt;
}

void keep(std::optional<Spot>& nearest, const Spot& spot) {
    if (!nearest || spot.distance < nearest->distance) nearest = spot;
}

}  // namespace

Picker::Picker(const World& world, const surface::DisplayMesh& mesh)
    : world_(world),
      mesh_(mesh),
      start_(world.cellCount() + 1, 0),
      triangles_(mesh.indices().size() / 3),
      reach_(world.cellCount(), 1) {
    const auto cellOf = [&](std::size_t index) {
        return mesh.vertices()[mesh.indices()[index]].cell;
    };
    for (std::size_t i = 0; i < mesh.indices().size(); i += 3) ++start_[cellOf(i) + 1];
    for (int cell = 0; cell < world.cellCount(); ++cell) start_[cell + 1] += start_[cell];
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < mesh.indices().size(); i += 3)
        triangles_[next[cellOf(i)]++] = static_cast<std::uint32_t>(i);

    for (const surface::DisplayVertex& vertex : mesh.vertices()) {
        const int cell = static_cast<int>(vertex.cell);
        const Vec3 size = world.bodies()[world.bodyOf(cell)].cellSize;
        const Vec3 centre = world.restPosition(kCorners * cell) + size / 2;
        const double away = (vertex.rest.cast<double>() - centre).norm() / (size.norm() / 2);
        reach_[cell] = std::max(reach_[cell], static_cast<float>(away));
    }
}

std::optional<Spot> Picker::pick(const State& state, const Vec3& origin,
                                 const Vec3& direction) const {
    std::optional<Spot> nearest;
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        if (!world_.present(cell)) continue;
        std::array<Vec3, kCorners> corners;
        Vec3 centre(0, 0, 0);
        for (int corner = 0; corner < kCorners; ++corner) {
            const int node = kCorners * cell + corner;
            corners[corner] = world_.restPosition(node) + state.displacement[node];
            centre += corners[corner] / kCorners;
        }
        const Vec3 to = centre - origin;
        const double along = to.dot(direction);
        const double aside = (to - along * direction).squaredNorm();
        double radius = 0;
        for (const Vec3& corner : corners) radius = std::max(radius, (corner - centre).norm());
        radius *= 1.05 * reach_[cell];
        if (aside > radius * radius || along < -radius) continue;
        if (nearest && along - radius > nearest->distance) continue;
        pickCell(state, cell, origin, direction, nearest);
    }
    pickObjects(state, origin, direction, nearest);
    return nearest;
}

void Picker::pickCell(const State& state, int cell, const Vec3& origin, const Vec3& direction,
                      std::optional<Spot>& nearest) const {
    for (std::uint32_t t = start_[cell]; t < start_[cell + 1]; ++t) {
        std::array<Vec3, 3> corners;
        bool hidden = false;
        for (int i = 0; i < 3 && !hidden; ++i) {
            const surface::DisplayVertex& vertex =
                mesh_.vertices()[mesh_.indices()[triangles_[t] + i]];
            hidden = surface::displayHidden(state, vertex);
            if (!hidden) corners[i] = surface::displayedPosition(world_, state, vertex);
        }
        if (hidden) continue;
        if (const auto distance =
                meetTriangle(origin, direction, corners[0], corners[1], corners[2]))
            keep(nearest, {origin + *distance * direction, *distance, cell, -1});
    }
}

void Picker::pickObjects(const State& state, const Vec3& origin, const Vec3& direction,
                         std::optional<Spot>& nearest) const {
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        const ObjectState& object = state.objects[i];
        const Object& shape = world_.objects()[i];
        if (!object.present) continue;
        const Eigen::Quaterniond turn = object.orientation.conjugate();
        const auto distance = shape.core.isZero(0)
                                  ? meetSphere(origin, direction, object.position, shape.radius)
                                  : meetBox(turn * (origin - object.position), turn * direction,
                                            shape.core + Vec3::Constant(shape.radius));
        if (distance)
            keep(nearest, {origin + *distance * direction, *distance, -1, static_cast<int>(i)});
    }
}

}  // namespace sunder::view
