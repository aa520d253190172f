#include "core/strength_map.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace sunder::core {
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

/// The same place, unless a lattice is so fine that its points there have no numbers: a description
/// may ask for chunks of 1e-300 m.
Vec3 numbered(const Vec3& p) {
    return p.cwiseMax(-0x1p52).cwiseMin(0x1p52);
}

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

/// A Voronoi cluster: its number, and its site in units of clusterSize.
struct Site {
    std::uint64_t cluster = 0;
    Vec3 position = Vec3::Zero();
};

/// Nearest of one jittered site per lattice cell, over the axes in `spans` only (1: yes, 0: no).
Site nearestSite(const Vec3& p, const IVec3& spans, std::uint64_t seed) {
    const LatticePoint base = floorOf(p);
    double best = 1e300;
    Site nearest;
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
                    nearest = {key, site};
                }
            }
    return nearest;
}

/// Axes along which clusters have a size; along the others they reach through the whole body.
IVec3 clusterSpans(const Material& material) {
    return (material.clusterSize.array() > 0).cast<int>();
}

/// In units of clusterSize, numbered(); 0 along axes without one.
Vec3 inClusters(const Material& material, const Vec3& p) {
    Vec3 q = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
        if (material.clusterSize[axis] > 0) q[axis] = p[axis] / material.clusterSize[axis];
    return numbered(q);
}

/// By how much a row of bricks is shifted, in bricks.
double rowShift(double row) {
    return static_cast<std::int64_t>(row) & 1 ? 0.5 : 0;
}

/// The shortest way along `axes`, m, from q (in clusters) to where the bisectors of the first site
/// and each of the next `planes` meet.
Vec3 ontoPlanes(const Material& material, const Vec3& q, const std::vector<Site>& sites, int planes,
                const Eigen::Array3i& axes) {
    // |q − s₀|² = |q − sₘ|² is linear in q.
    Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> normals(planes, 3);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> distances(planes);
    for (int m = 0; m < planes; ++m) {
        const Vec3 &a = sites[0].position, &b = sites[m + 1].position;
        for (int axis = 0; axis < 3; ++axis)
            normals(m, axis) =
                axes[axis] ? 2 * (b[axis] - a[axis]) / material.clusterSize[axis] : 0;
        distances[m] = (q - b).squaredNorm() - (q - a).squaredNorm();
    }
    return normals.completeOrthogonalDecomposition().solve(distances);
}

/// From `p` to the bisectors of the sites around it.
Vec3 towardsBisectors(const Material& material, const Vec3& p, std::span<const Vec3> centres,
                      const Vec3& reach, std::uint64_t seed) {
    const Eigen::Array3i free = (reach.array() > 0).cast<int>();
    const IVec3 spans = clusterSpans(material);
    const Vec3 q = inClusters(material, p);
    std::vector<Site> sites;
    for (const Vec3& centre : centres) {
        const Site site = nearestSite(inClusters(material, centre), spans, seed);
        if (std::none_of(sites.begin(), sites.end(),
                         [&](const Site& known) { return known.cluster == site.cluster; }))
            sites.push_back(site);
    }
    std::sort(sites.begin(), sites.end(), [&](const Site& a, const Site& b) {
        return (q - a.position).squaredNorm() < (q - b.position).squaredNorm();
    });
    // Where as many clusters as possible meet, unless that is too far off. An axis along which the
    // way is too long gives what it can, and the others the rest.
    const Eigen::Array3i movable = free * spans.array();
    const int most = std::min<int>(static_cast<int>(sites.size()) - 1, movable.sum());
    Vec3 shift = Vec3::Zero();
    for (int planes = most; planes > 0; --planes) {
        Vec3 fixed = Vec3::Zero();
        for (Eigen::Array3i axes = movable; axes.sum() >= planes;) {
            shift =
                fixed + ontoPlanes(material, q + inClusters(material, fixed), sites, planes, axes);
            int longest = 0;
            const Vec3 excess = shift.cwiseAbs() - reach;
            if (excess.maxCoeff(&longest) <= 1e-12) return shift;
            fixed[longest] = std::copysign(reach[longest], shift[longest]);
            axes[longest] = 0;
        }
    }
    return shift.cwiseMax(-reach).cwiseMin(reach);
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
    const Vec3 q = inClusters(material, p);
    switch (material.clusters) {
        case ClusterKind::None:
            return 0;
        case ClusterKind::Voronoi:
            return nearestSite(q, clusterSpans(material), seed).cluster;
        case ClusterKind::RunningBond:
            return latticeKey(floorOf({q[0] + rowShift(std::floor(q[1])), q[1], q[2]}));
        case ClusterKind::Planks:
            return latticeKey(floorOf({q[0], 0, 0}));
    }
    return 0;
}

Vec3 towardsClusterBoundary(const Material& material, const Vec3& p, std::span<const Vec3> centres,
                            const Vec3& reach, std::uint64_t seed) {
    Vec3 shift = Vec3::Zero();
    if (material.clusters == ClusterKind::None) return shift;
    if (material.clusters == ClusterKind::Voronoi)
        return towardsBisectors(material, p, centres, reach, seed).cwiseMax(-reach).cwiseMin(reach);
    // Planes across the axes: whichever of them pass between the centres.
    for (int axis = 0; axis < 3; ++axis) {
        const double size = material.clusterSize[axis];
        if (reach[axis] <= 0 || size <= 0 || (material.clusters == ClusterKind::Planks && axis > 0))
            continue;
        for (const Vec3& a : centres)
            for (const Vec3& b : centres) {
                // Neighbours across this plane, in one row of bricks.
                if (!(a[axis] < b[axis]) || (axis != 1 && a[1] != b[1])) continue;
                const double offset = material.clusters == ClusterKind::RunningBond && axis == 0
                                          ? rowShift(std::floor(inClusters(material, a)[1]))
                                          : 0;
                const double low = a[axis] / size + offset, high = b[axis] / size + offset;
                if (std::floor(low) != std::floor(high))
                    shift[axis] = (std::floor(high) - offset) * size - p[axis];
            }
    }
    return shift.cwiseMax(-reach).cwiseMin(reach);
}

double bondStrength(const Material& material, const Vec3& a, const Vec3& b, int axis,
                    std::uint64_t bond, std::uint64_t seed) {
    const bool boundary = clusterOf(material, a, seed) != clusterOf(material, b, seed);
    double strength = (boundary ? material.boundaryStrength : material.strength)[axis];
    strength *= weibullFactor(material.spread, hashUniform(seed, bond, 4));
    if (material.noiseLength > 0)
        strength *= 1 + material.noiseAmplitude *
                            smoothNoise(numbered(0.5 * (a + b) / material.noiseLength), seed);
    return strength;
}

}  // namespace sunder::core
