#pragma once
#include <cstdint>
#include <span>

#include "core/material.hpp"

namespace sunder::core {

/// A pure function of (seed, a, b): a uniform number in [0, 1). Independent of call order, the same
/// on every machine.
double hashUniform(std::uint64_t seed, std::uint64_t a, std::uint64_t b);

/// Number of the cluster a point belongs to. `p`: m, in the body's frame, measured from its origin.
std::uint64_t clusterOf(const Material&, const Vec3& p, std::uint64_t seed);

/// By how much a corner of cells at `p` must move, m, for the cells' outlines to follow their
/// clusters: to the nearest point on the boundary of the clusters around it, but along each axis at
/// most by `reach`. `centres`: of the cells around the corner, m, in the body's frame like `p`.
/// Zero where all are of one cluster.
Vec3 towardsClusterBoundary(const Material&, const Vec3& p, std::span<const Vec3> centres,
                            const Vec3& reach, std::uint64_t seed);

/// Strength in Pa of the bond between cells centred at `a` and `b` = a + one cell along `axis`
/// (docs/fracture.md, point 8). `bond` names the bond for the random factor.
double bondStrength(const Material&, const Vec3& a, const Vec3& b, int axis, std::uint64_t bond,
                    std::uint64_t seed);

}  // namespace sunder::core
