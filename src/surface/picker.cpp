#include "surface/picker.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sunder::surface {

using namespace core;

namespace {

struct Meeting {
    double distance;  ///< m, along the ray
    double u, v;      ///< place in the triangle: shares of its second and third corner
};

/// Where the ray enters a triangle, from either side (Möller and Trumbore 1997); none where it
/// passes by.
std::optional<Meeting> meetTriangle(const Vec3& origin, const Vec3& direction, const Vec3& a,
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
    return distance > 0 ? std::optional(Meeting{distance, u, v}) : std::nullopt;
}

/// Around the origin.
std::optional<double> meetSphere(const Vec3& origin, const Vec3& direction, double radius) {
    const Vec3 to = -origin;
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

Picker::Picker(const World& world, const DisplayMesh& mesh)
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

    for (const DisplayVertex& vertex : mesh.vertices()) {
        const int cell = static_cast<int>(vertex.cell);
        const Body& body = world.bodies()[world.bodyOf(cell)];
        const Vec3& size = body.cellSize;
        const Vec3 centre = world.restPosition(kCorners * cell) + body.axes * (size / 2);
        const double away = (vertex.rest.cast<double>() - centre).norm() / (size.norm() / 2);
        reach_[cell] = std::max(reach_[cell], static_cast<float>(away));
    }
}

std::optional<Spot> Picker::pick(const State& state, const Vec3& origin,
                                 const Vec3& direction) const {
    std::optional<Spot> nearest;
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        if (!world_.present(cell, state)) continue;
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
        std::array<Vec3, 3> corners, rest;
        bool hidden = false;
        for (int i = 0; i < 3 && !hidden; ++i) {
            const DisplayVertex& vertex = mesh_.vertices()[mesh_.indices()[triangles_[t] + i]];
            hidden = displayHidden(state, vertex);
            if (hidden) break;
            corners[i] = displayedPosition(world_, state, vertex);
            rest[i] = vertex.rest.cast<double>();
        }
        if (hidden) continue;
        const auto meeting = meetTriangle(origin, direction, corners[0], corners[1], corners[2]);
        if (!meeting) continue;
        const auto& [distance, u, v] = *meeting;
        keep(nearest,
             {.place = origin + distance * direction,
              .distance = distance,
              .cell = cell,
              .normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized(),
              .rest = (1 - u - v) * rest[0] + u * rest[1] + v * rest[2]});
    }
}

void Picker::pickObjects(const State& state, const Vec3& origin, const Vec3& direction,
                         std::optional<Spot>& nearest) const {
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        const ObjectState& object = state.objects[i];
        const Object& shape = world_.objects()[i];
        if (!object.present) continue;
        const Eigen::Quaterniond turn = object.orientation.conjugate();
        const Vec3 from = turn * (origin - object.position), along = turn * direction;
        const bool ball = shape.core.isZero(0);
        const Vec3 half = shape.core + Vec3::Constant(shape.radius);
        const auto distance =
            ball ? meetSphere(from, along, shape.radius) : meetBox(from, along, half);
        if (!distance) continue;
        // Of a box: the axis along which the place lies farthest out.
        const Vec3 place = from + *distance * along;
        Vec3 normal = place.normalized();
        if (!ball) {
            int axis = 0;
            place.cwiseQuotient(half).cwiseAbs().maxCoeff(&axis);
            normal = std::copysign(1.0, place[axis]) * Vec3::Unit(axis);
        }
        keep(nearest, {.place = origin + *distance * direction,
                       .distance = *distance,
                       .object = static_cast<int>(i),
                       .normal = object.orientation * normal});
    }
}

}  // namespace sunder::surface
