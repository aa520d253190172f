#pragma once
#include <algorithm>
#include <array>

#include "core/contact.hpp"
#include "core/object.hpp"

namespace sunder {

/// How objects touch cells, each other and the ground: the model that every solver implements.
///
/// Everything is a rounded box: all points within a radius of a core (Object). A cell's box follows
/// its nodes (CellMotion::box()); its radius is a tenth of its shortest edge. The normal n points
/// from the object to what it touches, x and y are the points of the two cores that lie nearest,
/// found by projecting kProjections times from one to the other, v is the velocity of the other
/// side relative to the object's at the contact. What moves far in a step is moved along its way
/// until it touches (at most kAdvances times as far as the gap allows), so nothing is jumped over.
///
/// Two sides touch in a step where they would come closer than the gap g allows:
///
///   u = −g/h (g > 0),  −g/max(kPartingTime, h/κ) (g ≤ 0),   touch where v·n < u
///   impulse p = M·(max(u, e·|v·n|) − v·n), the e term where |v·n| > kBounceSpeed
///   friction  opposite to the tangential v_t: min(μ·p, M_t·|v_t|)
///   1/M = N·c + K·(1/m + (r×n)·I⁻¹(r×n)),  1/M_t = N·c + K·(1/m + |r|²·max I⁻¹)
///
/// c is what the other side gives way per impulse: of a cell (8·Σw²)/mass, where w are the
/// trilinear weights with which the impulse goes to its corners. N and K are the numbers of touches
/// that the cell and the object have in this step: each touch gets its share of their masses (mass
/// splitting, Tonge et al. 2012), so that all together never add energy. e and μ are means of both
/// sides'.
///
/// A share of its mass is all that an object has to hold up another with, so a light one would sink
/// under a heavy one. An object that others squeeze between them therefore answers touches with the
/// mass that it carries, m' = max(m, load), instead of m, above and in what an impulse does to its
/// motion and spin; gravity goes on pulling at m. Squeezed means: touches whose impulses cancel,
///
///   load = ½·(Σ|p| + |Σp_cells| − |Σp|)/(h·g₀),  g₀ = 9.81 m/s²
///
/// over objects, barriers and a chain, cells all together. It grows at once and fades within
/// kLoadTime, so that it hardly changes while a stack swings (changing with it would drive it), or
/// within kUnloadTime where nothing but cells touches the object. One that is hit from one side has
/// none.
inline constexpr double kBounceSpeed = 0.3;  ///< m/s
inline constexpr int kProjections = 6;
inline constexpr int kAdvances = 8;
inline constexpr double kCellRoundness = 0.1;  ///< radius of a cell's box in shortest edges
inline constexpr double kLoadTime = 0.1;       ///< s
inline constexpr double kUnloadTime = 2e-3;    ///< s

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
    Vec3 all{0, 0, 0}, cells{0, 0, 0};
    double others = 0;  ///< of the sizes of those that no cell gave
};
/// kg, after a step. most: no object carries more than everything there is.
double loadAfter(double load, const TouchSum& sum, double step, double most);
/// kg, of all bodies and objects.
double massOf(const World& world);

/// Of an object, before it is multiplied by K.
Yield yieldOf(const Object& object, const ObjectState& state, const Touch& touch);
inline Yield yieldOf(double inverseMass) {
    return {inverseMass, inverseMass};
}

/// N·s on the second side of a touch, where touches() holds.
Vec3 touchImpulse(const Touch& touch, const Vec3& velocity, const Yield& yield, double restitution,
                  double friction, double step);

}  // namespace sunder
