#include "core/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::core {
namespace {

constexpr int kMostSpheres = 8;

/// Restitution of two spheres with that α, mean over where in a step they first touch; h, M and the
/// speed of approach are 1.
double restitutionOf(double damping) {
    constexpr int phases = 16;
    double sum = 0;
    for (int phase = 0; phase < phases; ++phase) {
        double x = -(phase + 0.5) / phases, v = -1;
        while (x < 0 || v < 0) {
            if (x < 0) {
                const double touching = std::min(1.0, -x / std::max(std::abs(v), 1e-9));
                v += std::max(0.0, -kContactStiffness * x - damping * touching * v);
            }
            x += v;
        }
        sum += v;
    }
    return sum / phases;
}

}  // namespace

double contactDamping(double restitution) {
    double low = 0, high = kInelasticDamping;
    if (restitutionOf(high) >= restitution) return high;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (restitutionOf(middle) > restitution ? low : high) = middle;
    }
    return low;
}

Vec3 ContactProxy::place(int sphere) const {
    const IVec3 at{sphere % count[0], sphere / count[0] % count[1], sphere / (count[0] * count[1])};
    return (at.cast<double>() + Vec3::Constant(0.5)).cwiseQuotient(count.cast<double>());
}

std::array<double, kCorners> trilinearWeights(const Vec3& place) {
    std::array<double, kCorners> result{};
    for (int corner = 0; corner < kCorners; ++corner) {
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis)
            weight *= corner >> axis & 1 ? place[axis] : 1 - place[axis];
        result[static_cast<std::size_t>(corner)] = weight;
    }
    return result;
}

double ContactProxy::reach(const Vec3& cellSize) const {
    return (place(0) - Vec3::Constant(0.5)).cwiseProduct(cellSize).norm() + radius;
}

ContactProxy contactProxy(const Vec3& cellSize) {
    const double shortest = cellSize.minCoeff();
    ContactProxy proxy;
    proxy.radius = shortest / 2;
    for (int axis = 0; axis < 3; ++axis)
        proxy.count[axis] =
            std::clamp(static_cast<int>(std::lround(std::min(cellSize[axis] / shortest, 8.0))), 1,
                       kMostSpheres);
    while (proxy.spheres() > kMostSpheres) {
        int longest = 0;
        proxy.count.maxCoeff(&longest);
        --proxy.count[longest];
    }
    return proxy;
}

double touchTime(const Vec3& x, const Vec3& v, double radii, double step) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const double apart = x.squaredNorm() - radii * radii;
    if (apart < 0) return 0;
    const double along = x.dot(v), squared = v.squaredNorm(), way = kSweptWay * radii / step;
    if (along >= 0 || squared <= way * way) return never;
    const double root = along * along - squared * apart;
    const double time = root < 0 ? never : apart / (std::sqrt(root) - along);
    return time <= step ? time : never;
}

double closestApproach(const Vec3& x, const Vec3& v, double time) {
    const double squared = v.squaredNorm();
    return (x + (squared > 0 ? std::clamp(-x.dot(v) / squared, 0.0, time) : 0) * v).norm();
}

double contactMargin(double radiusA, double radiusB, double speed, double time) {
    return std::max(0.5 * (radiusA + radiusB), 1.1 * time * speed);
}

}  // namespace sunder::core
