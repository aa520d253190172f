#pragma once
#include <algorithm>
#include <array>

#include "core/constants.hpp"
#include "core/contact.hpp"
#include "core/object.hpp"

namespace sunder::core {

class World;

// How objects touch cells, each other and the ground: the model that every solver implements.
//
// Everything is a rounded box: all points within a radius of a core (Object). A cell's box follows
// its nodes (CellMotion::box()); its radius is a tenth of its shortest edge. The normal n points
// from the object to what it touches, x and y are the points of the two cores that lie nearest,
// found by projecting kProjections times from one to the other, v is the velocity of the other
// side relative to the object's at the contact. What moves far in a step is moved along its way
// until it touches (at most kAdvances times as far as the gap allows), so nothing is jumped over.
//
// Two sides touch in a step where they would come closer than the gap g allows:
//
//   u = −g/h (g > 0),  −g/max(kPartingTime, h/κ) (g ≤ 0),   touch where v·n < u
//   impulse p = M·(max(u, e·|v·n|) − v·n), the e term where |v·n| > kBounceSpeed
//   friction  opposite to the tangential v_t: min(μ·p, M_t·|v_t|)
//   1/M = N·c + K·(1/m + (r×n)·I⁻¹(r×n)),  1/M_t = N·c + K·(1/m + |r|²·max I⁻¹)
//
// An overlap never asks for more than U, what things part gently at (World::pushSpeed()): one that
// is deeper counts as no deeper than that, limitDepth(). With its centre
// in a body, where cells would push it to all sides, or its core in that of a cell, an object is
// pushed along the shortest way out by all of them that are whole: wayOut(). Two
// objects whose cores meet push each other once and not at every corner: deepTouch().
//
// c is what the other side gives way per impulse: of a cell (8·Σw²)/mass, where w are the
// trilinear weights with which the impulse goes to its corners. N and K are the numbers of touches
// that the cell and the object have in this step: each touch gets its share of their masses (mass
// splitting, Tonge et al. 2012), so that all together never add energy. e and μ are means of both
// sides'.
//
// A share of its mass is all that an object has to hold up another with, so a light one would sink
// under a heavy one. An object that others squeeze between them therefore answers touches with
// what it carries, m' = max(m, kLoadMargin·load), instead of m, above and in what an impulse does
// to its motion and spin; gravity goes on pulling at m. Squeezed means: touches whose impulses
// cancel, along one of the world's axes a,
//
//   squeeze(p) = max_a ½·(Σ|p_a| + |q_a| − |Σp_a + q_a|)/(h·g₀),  g₀ = 9.81 m/s²
//
// over objects and barriers, q from all cells together or from a chain, whichever squeezes more
// (between chain and cells hangs a ball that breaks a wall, and that has no more to it than its
// mass); hits, which approach faster than kPressingSpeed, do not count, so that what is hit where
// it stands flies off as light as it is.
// The load follows squeeze(p) within kLoadTime. Within kGrowthTime it grows to what the impulses
// that stop an approach, at most M·|v·n|, squeeze: were it to follow an overlap so fast, which
// presses the harder the larger M is, it would drive a stack to swing. For the same reason loaded
// objects part slowly: an overlap with another object or a barrier counts as max(m/m',
// kLoadedDepth) of itself. Where neither objects nor barriers touch the object, the load fades
// within kUnloadTime. What grows heavier keeps its momentum m'·v and becomes slower, so a changing
// load never adds energy.

/// A box somewhere, and how far around it counts.
struct RoundedBox {
    Vec3 centre{0, 0, 0};
    Mat3 axes = Mat3::Identity();  ///< columns, orthonormal
    Vec3 half{0, 0, 0};            ///< m, of the core
    double radius = 0;             ///< m
    /// The core's point nearest to x.
    Vec3 nearest(const Vec3& x) const;
};
RoundedBox boxOf(const Object& object, const ObjectState& state);

/// A cell's corners: m, m/s.
struct CellMotion {
    std::array<Vec3, kCorners> position, velocity;
    bool still() const {
        return std::all_of(velocity.begin(), velocity.end(),
                           [](const Vec3& v) { return v.isZero(0); });
    }
    /// edges: of the cell at rest, m.
    RoundedBox box(const Vec3& edges) const;
};
/// Trilinear weights of a cell's corners for an impulse at x: those of the nearest place that
/// spheres of its ContactProxy could have.
std::array<double, kCorners> cornerWeights(const RoundedBox& cell, const ContactProxy& proxy,
                                           const Vec3& x);

struct Touch {
    Vec3 normal{0, 1, 0};
    Vec3 point{0, 0, 0};  ///< m, midway between the surfaces
    double gap = 0;       ///< m, negative: overlap; along the normal
};
/// Of two resting boxes; the normal points from the first to the second.
Touch touchOf(const RoundedBox& from, const RoundedBox& to);
/// The second moves at `velocity` (m/s) relative to the first for `step` (s).
Touch sweptTouch(const RoundedBox& from, const RoundedBox& to, const Vec3& velocity, double step);

/// So that the touch asks for no more than `speed` (m/s): what came to overlap by no hit parts
/// gently.
void limitDepth(Touch& touch, double speed, double step);
/// Of two boxes whose cores meet (their touch has a gap of minus the radii): the normal is the axis
/// of one of them on which they are apart soonest.
Touch deepTouch(const RoundedBox& from, const RoundedBox& to);
/// Where a cell is whole, joined to all cells that its body has room for around it: the unit vector
/// along one of the cell's axes on which x is out of the body soonest, and by how much, m, in
/// `depth`: negative where it is out. below, above: m, from the cell's centre to the body's ends.
Vec3 wayOut(const RoundedBox& cell, const Vec3& below, const Vec3& above, const Vec3& x,
            double& depth);
/// m/s: the speed of parting that a gap asks for, u.
double partingSpeed(double gap, double step);
inline bool touches(const Touch& touch, const Vec3& velocity, double step) {
    return velocity.dot(touch.normal) < partingSpeed(touch.gap, step);
}

/// What both sides give way per impulse along the normal and across it, 1/kg: 1/M and 1/M_t.
struct Yield {
    double normal = 0, tangential = 0;
    Yield& operator+=(const Yield& other) {
        normal += other.normal;
        tangential += other.tangential;
        return *this;
    }
    Yield operator*(double share) const { return {share * normal, share * tangential}; }
};
/// m/m' of an object, 1 at most.
double loadShare(const Object& object, const ObjectState& state);
/// What touches gave an object in a step, N·s.
struct TouchSum {
    Vec3 all{0, 0, 0};
    Vec3 cells{0, 0, 0};
    Vec3 chain{0, 0, 0};
    /// Of objects and barriers that press: sums, and those of their components' sizes.
    struct Pressing {
        Vec3 sum{0, 0, 0}, sizes{0, 0, 0};
        void add(const Vec3& p) {
            sum += p;
            sizes += p.cwiseAbs();
        }
    };
    Pressing pressing, stopping;  ///< stopping: the parts that stop an approach
};
/// kg, after a step. most: no object carries more than everything there is.
double loadAfter(const Object& object, double load, const TouchSum& sum, double step, double most);
/// kg, of all bodies and objects.
double massOf(const World& world);
/// m/s: loaded objects that overlap each other or a barrier part no faster: twenty times what
/// gravity adds in a step, for a box on its corners needs four times that to be carried. Much
/// faster, a stack that was pressed together would jump.
double settlingSpeed(const World& world);

/// Of an object, before it is multiplied by K.
Yield yieldOf(const Object& object, const ObjectState& state, const Touch& touch);
inline Yield yieldOf(double inverseMass) {
    return {inverseMass, inverseMass};
}

/// The part of an impulse's size, N·s, that stops the approach of two sides.
double stoppingPart(const Touch& touch, const Vec3& velocity, const Yield& yield,
                    const Vec3& impulse);
/// N·s on the second side of a touch, where touches() holds.
Vec3 touchImpulse(const Touch& touch, const Vec3& velocity, const Yield& yield, double restitution,
                  double friction, double step);

}  // namespace sunder::core
