#include "core/box_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder::core {
namespace {

/// m: by how much two cores are apart along an axis, or, negative, reach over each other.
double alongAxis(const RoundedBox& a, const RoundedBox& b, const Vec3& axis) {
    const auto reach = [&](const RoundedBox& box) {
        return (box.axes.transpose() * axis).cwiseAbs().dot(box.half);
    };
    return std::abs(axis.dot(b.centre - a.centre)) - reach(a) - reach(b);
}

/// The largest of them over the faces' normals and the edges' cross products. Two boxes that meet
/// come apart soonest along one of these; where it is positive, they do not meet.
double largestAlongAxes(const RoundedBox& a, const RoundedBox& b) {
    double largest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        largest =
            std::max({largest, alongAxis(a, b, a.axes.col(i)), alongAxis(a, b, b.axes.col(i))});
        for (int j = 0; j < 3; ++j) {
            const Vec3 across = a.axes.col(i).cross(b.axes.col(j));
            // Parallel edges: the faces' normals have it all.
            if (const double length = across.norm(); length > 1e-9)
                largest = std::max(largest, alongAxis(a, b, across / length));
        }
    }
    return largest;
}

struct Edge {
    Vec3 middle, half;  ///< m
};

std::array<Edge, 12> edgesOf(const RoundedBox& box) {
    std::array<Edge, 12> edges;
    for (int number = 0; number < 12; ++number) {
        const int axis = number / 4;
        Vec3 middle = Vec3::Zero(), half = Vec3::Zero();
        half[axis] = box.half[axis];
        for (const int side : {0, 1}) {
            const int across = (axis + 1 + side) % 3;
            middle[across] = (number >> side & 1 ? 1 : -1) * box.half[across];
        }
        edges[static_cast<std::size_t>(number)] = {box.centre + box.axes * middle, box.axes * half};
    }
    return edges;
}

/// m. The squared distance is convex in the two places, −1 to 1, so each may be cut off to its
/// range and the other one follow.
double between(const Edge& a, const Edge& b) {
    const Vec3 apart = b.middle - a.middle;
    const double aa = a.half.squaredNorm(), bb = b.half.squaredNorm(), ab = a.half.dot(b.half);
    const double da = apart.dot(a.half), db = apart.dot(b.half);
    const auto cut = [](double x) { return std::clamp(x, -1.0, 1.0); };
    const auto onA = [&](double t) { return aa > 0 ? cut((da + t * ab) / aa) : 0; };
    const auto onB = [&](double s) { return bb > 0 ? cut((s * ab - db) / bb) : 0; };
    const double parallel = aa * bb - ab * ab;
    double s = parallel > 1e-12 * aa * bb ? cut((da * bb - db * ab) / parallel) : 0;
    const double t = onB(s);
    s = onA(t);
    return (apart + onB(s) * b.half - s * a.half).norm();
}

/// m, of cores that do not meet: they are nearest at a corner of one of them, or at two edges.
double distanceOf(const RoundedBox& a, const RoundedBox& b) {
    double least = std::numeric_limits<double>::infinity();
    const auto edgesA = edgesOf(a), edgesB = edgesOf(b);
    const auto corners = [&](const std::array<Edge, 12>& edges, const RoundedBox& to) {
        for (std::size_t i = 0; i < 4; ++i)
            for (const int end : {-1, 1}) {
                const Vec3 corner = edges[i].middle + end * edges[i].half;
                least = std::min(least, (corner - to.nearest(corner)).norm());
            }
    };
    corners(edgesA, b);
    corners(edgesB, a);
    for (const Edge& first : edgesA)
        for (const Edge& second : edgesB) least = std::min(least, between(first, second));
    return least;
}

}  // namespace

double gapBetween(const RoundedBox& a, const RoundedBox& b) {
    const double radii = a.radius + b.radius, largest = largestAlongAxes(a, b);
    // Farther apart along an axis than the radii: they do not touch, and how far does not matter
    // to the last digit.
    if (largest <= 0 || largest > radii) return largest - radii;
    return distanceOf(a, b) - radii;
}

}  // namespace sunder::core
