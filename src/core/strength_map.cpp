#include "core/strength_map.hpp"

#include <algorithm>
#include <cmath>

namespace sunder {
namespace {

/// SplitMix64's finaliser (Steele, Lea, Flood 2014).
std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint64_t hash(std::uint64_t seed, std::uint64_t a, std::uint64_t b) {
    return mix(mix(mix(seed + 0x9e3779b97f4a7c15u) + a) + b * 0x9e3779b97f4a7c15u);
}

std::uint64_t latticeKey(const Eigen::Matrix<std::int64_t, 3, 1>& c) {
    return mix(static_cast<std::uint64_t>(c[0]) * 0x8da6b343u ^
               mix(static_cast<std::uint64_t>(c[1]) * 0xd8163841u ^
                   mix(static_cast<std::uint64_t>(c[2]) + 0xcb1ab31fu)));
}

using LatticePoint = Eigen::Matrix<std::int64_t, 3, 1>;

LatticePoint floorOf(const Vec3& p) {
    return {static_cast<std::int64_t>(std::floor(p[0])),
            static_cast<std::int64_t>(std::floor(p[1])),
            static_cast<std::int64_t>(std::floor(p[2]))};
}

/// Smooth value noise in [−1, 1] with one random value per unit of length.
double smoothNoise(const Vec3& p, std::uint64_t seed) {
    const LatticePoint base = floorOf(p);
    Vec3 t = p - base.cast<double>();
    t = t.array().square() * (3 - 2 * t.array());
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const LatticePoint offset(corner & 1, corner >> 1 & 1, corner >> 2);
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) weight *= offset[axis] ? t[axis] : 1 - t[axis];
        sum += weight * (2 * hashUniform(seed, latticeKey(base + offset), 7) - 1);
    }
    return sum;
}

/// Nearest of one jittered site per lattice cell, over the axes in `spans` only (1: yes, 0: no).
std::uint64_t voronoiCluster(const Vec3& p, const IVec3& spans, std::uint64_t seed) {
    const LatticePoint base = floorOf(p);
    double best = 1e300;
    std::uint64_t cluster = 0;
    for (int dz = -spans[2]; dz <= spans[2]; ++dz)
        for (int dy = -spans[1]; dy <= spans[1]; ++dy)
            for (int dx = -spans[0]; dx <= spans[0]; ++dx) {
                const LatticePoint c = base + LatticePoint(dx, dy, dz);
                const std::uint64_t key = latticeKey(c);
                const Vec3 jitter(hashUniform(seed, key, 1), hashUniform(seed, key, 2),
                                  hashUniform(seed, key, 3));
                const Vec3 site = c.cast<double>() + jitter.cwiseProduct(spans.cast<double>());
                const double distance = (p - site).squaredNorm();
                if (distance < best) {
                    best = distance;
                    cluster = key;
                }
            }
    return cluster;
}

/// Weibull variate of mean 1 and modulus 1.2/spread, kept in [0.25, 3].
double weibullFactor(double spread, double uniform) {
    if (spread <= 0) return 1;
    const double modulus = 1.2 / spread;
    const double value =
        std::pow(-std::log1p(-uniform), 1 / modulus) / std::tgamma(1 + 1 / modulus);
    return std::clamp(value, 0.25, 3.0);
}

}  // namespace

double hashUniform(std::uint64_t seed, std::uint64_t a, std::uint64_t b) {
    return static_cast<double>(hash(seed, a, b) >> 11) * 0x1p-53;
}

std::uint64_t clusterOf(const Material& material, const Vec3& p, std::uint64_t seed) {
    // Size 0 along an axis: clusters reach through the whole body there.
    const IVec3 spans = (material.clusterSize.array() > 0).cast<int>();
    Vec3 q = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
        if (spans[axis]) q[axis] = p[axis] / material.clusterSize[axis];
    switch (material.clusters) {
        case ClusterKind::None:
            return 0;
        case ClusterKind::Voronoi:
            return voronoiCluster(q, spans, seed);
        case ClusterKind::RunningBond: {
            const auto row = static_cast<std::int64_t>(std::floor(q[1]));
            const double shift = row & 1 ? 0.5 : 0;
            return latticeKey(floorOf({q[0] + shift, q[1], q[2]}));
        }
        case ClusterKind::Planks:
            return latticeKey(floorOf({q[0], 0, 0}));
    }
    return 0;
}

double bondStrength(const Material& material, const Vec3& a, const Vec3& b, int axis,
                    std::uint64_t bond, std::uint64_t seed) {
    const bool boundary = clusterOf(material, a, seed) != clusterOf(material, b, seed);
    double strength = (boundary ? material.boundaryStrength : material.strength)[axis];
    strength *= weibullFactor(material.spread, hashUniform(seed, bond, 4));
    if (material.noiseLength > 0)
        strength *=
            1 + material.noiseAmplitude * smoothNoise(0.5 * (a + b) / material.noiseLength, seed);
    return strength;
}

}  // namespace sunder
