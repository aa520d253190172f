#pragma once
#include <array>
#include <vector>

#include "core/cell.hpp"
#include "core/constants.hpp"
#include "core/types.hpp"

namespace sunder::core {

/// Contact between cells: the model that every solver implements.
///
/// A cell is a few equal spheres (ContactProxy) that ride on its nodes: a sphere's centre and
/// velocity are the trilinear mean of the eight corners' at its place, and a force on it goes to
/// the corners by the same weights. Two cells touch where spheres overlap, by δ = r_A + r_B − |x_A
/// − x_B| with the normal n from B to A and v the velocity of A relative to B:
///
///   M = M_A·M_B/(M_A + M_B), masses of the whole cells;  N = max(N_A, N_B)
///   normal force    f = max(0, κ·M/h²·δ − α·w·M/h·(v·n)) / N,  w = min(1, δ/(h·|v·n|))
///   friction        opposite to the tangential part v_t of v: min(μ·f, β·M/h·|v_t| / N)
///
/// Spheres that move far in a step would jump over each other: two that come nearer by more than
/// kSweptWay·(r_A + r_B) in a step and that touch within it meet there, with δ = 0 and n as it is
/// then (touchTime()), and part at once; so do those that overlap already:
///
///   f ≥ (1 + e)·M/h·(−v·n) / N
///
/// with κ = kContactStiffness, e the mean of the restitutions asked for, α of the dampings that
/// they make (contactDamping), μ of the two materials' friction, β = kFrictionRate. Stiffness and
/// damping in units of M and h obey the stability limit whatever the material: h²·k/M
/// + 2·h·c/M < 4. N, the number of sphere pairs of a cell that the last search found closer than
/// kCrowdGap radii, or on their way there before the next (at least 1), keeps that true in a crowd.
/// w is the share of the step that the spheres have been in touch for: without it the restitution
/// depends on where within a step they met (0.46 to 0.55 for 0.5; with it 0.495 to 0.505).
///
/// Neighbours on the body's lattice (all three coordinates differ by at most one) that once hung
/// together push each other only inelastically, so that a fresh crack does not explode, however
/// squeezed its sides were:
///
///   f = max(0, α₀·M/h·(δ/τ − v·n)) / N,  τ = max(kPartingTime, α₀·h/κ)
///
/// A crack whose sides were squeezed by δ opens at δ/τ at most, and one that bears a load W gives
/// way by N·W·h·τ/(α₀·M). (A bound on that speed itself would be a bound on the load: under more,
/// the sides would sink into each other without end.)
///
/// Two bodies that overlap as the world begins (World::partings(); the scene has allowed one of
/// them to) push each other with no more than
///
///   f = max(0, α₀·M/h·(U − v·n)) / N,  U = World::pushSpeed()
///
/// and n is the way out that the two have in common, while the overlap lasts (core/overlap.hpp):
/// so they part at twice U at most, however deep they are in each other. What they give up for it,
/// with each other and for good, is a rebound faster than that, and loads beyond α₀·M·U/h a pair:
/// between like cells 37 times a cell's weight at 50 substeps, in proportion to those.
///
/// Where cells of unequal mass touch (World::unequalCells()), M is next to the lighter one's, and
/// so is the weight that a spring of it could carry. The rest is what the lighter one answers with:
/// its elasticity, squeezed. So spheres that overlap, of cells that are no such neighbours, push
/// with the force of constraint as well, which stops them from accelerating into each other
/// (Gauss's principle). a is what a sphere's acceleration would be without contact: the mean over
/// its corners of F/m of the joined node, and gravity. C is what a newton on each cell that may
/// touch something would do to the sphere, spread evenly over the cell's corners, 1/kg:
///
///   f += −γ·(a_A − a_B)·n/(C_A + C_B)/N,   friction ≤ μ·f stops the rest of that in the same way
///
/// with γ = kConstraintShare: with all of it nothing would be left for the spring, and touch would
/// come and go. Friction holds at rest then, too.
///
/// Cells that still share a joined node never push each other. Which pairs may touch is searched
/// for every World::contactInterval() steps, before the step: pairs of spheres whose gap is less
/// than contactMargin().
inline constexpr double kContactTime = 1.0 / 750;  ///< s, from one search to the next
inline constexpr int kContactSteps = 4;            ///< but no fewer steps

/// α for a restitution e of 0 to 1: the one at which two spheres that meet head on part with e
/// times the speed, worked out with the very steps the solvers take. Restitutions below about 0.19
/// get kInelasticDamping.
double contactDamping(double restitution);

/// Trilinear weights of a cell's corners at a place in it, each coordinate 0 to 1.
std::array<double, kCorners> trilinearWeights(const Vec3& place);

/// A cell's spheres: count[a] along axis a, evenly spaced, product at most 8; radius half the
/// shortest edge. One for a cube; three for a cell three times as long as thick.
struct ContactProxy {
    IVec3 count{1, 1, 1};
    double radius = 0;  ///< m
    int spheres() const { return count.prod(); }
    /// Place of a sphere in the cell, each coordinate 0 to 1; x runs fastest.
    Vec3 place(int sphere) const;
    std::array<double, kCorners> weights(int sphere) const {
        return trilinearWeights(place(sphere));
    }
    /// m: from the centre of an undeformed cell to the farthest point of its spheres.
    double reach(const Vec3& cellSize) const;
};
ContactProxy contactProxy(const Vec3& cellSize);

/// s: when two spheres touch, the sum of whose radii is `radii` (m); x: one's centre less the
/// other's, m, v likewise, m/s. 0 where they do now. Infinite where they do not within `step` (s),
/// or are slow enough to be found overlapping.
double touchTime(const Vec3& x, const Vec3& v, double radii, double step);

/// m: how near the centres come within `time` (s).
double closestApproach(const Vec3& x, const Vec3& v, double time);

/// m: gap below which a pair is kept until the next search: half the sum of the radii, or how far
/// the pair closes in by then, in `time` (s), at the relative speed `speed` (m/s), a tenth on top.
double contactMargin(double radiusA, double radiusB, double speed, double time);

}  // namespace sunder::core
