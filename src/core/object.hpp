#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace sunder::core {

/// Cells and objects know each other by numbers that fit into a byte on the GPU.
inline constexpr int kMaxObjects = 250;

enum class ObjectShape { Sphere, Box, Capsule };

/// A rigid body that is no wall: something thrown, something hanging, an obstacle.
struct ObjectDescription {
    std::string name;
    ObjectShape shape = ObjectShape::Sphere;
    /// m: half the edges of a box, each 0.0005 to 500. Sphere: the radius, 0.001 to 1000, three
    /// times. Capsule: radius, half of the whole length along its y axis (radius to 1000), radius.
    Vec3 halfSize{0.1, 0.1, 0.1};
    double mass = 1;  ///< kg, 1e-6 to 1e9
    /// m, of its centre, each −1e4 to 1e4. None: not there until it is thrown; then it has no
    /// velocity, spin or chain, and is not fixed.
    std::optional<Vec3> position;
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of length 1
    Vec3 velocity{0, 0, 0};                                           ///< m/s, each −1e4 to 1e4
    Vec3 spin{0, 0, 0};     ///< rad/s, about the world's axes, each −1e4 to 1e4
    double friction = 0.5;  ///< Coulomb μ, 1, 0 to 10; with a material or other object: the mean
    double restitution = 0.3;  ///< e, 1, 0 to 1; likewise
    double drag = 0.05;        ///< 1/s, 0 to 1000, of motion and spin
    bool fixed = false;        ///< an obstacle: never moves, has no velocity, spin or chain
    /// Moves as it is told to and by nothing else: velocity and spin stay what they are until it is
    /// put somewhere (Solver::putObject()). Neither thrown nor hung.
    bool kinematic = false;
    /// m, each −1e4 to 1e4: on a chain from here, as long as the way there at first, at least
    /// 0.001.
    std::optional<Vec3> hungFrom;
    Vec3 colour{0.25, 0.25, 0.28};  ///< linear RGB, each 0 to 1
    bool mayOverlap = false;        ///< when the world begins (core/overlap.hpp)
    std::string where;  ///< for error messages, for example "balls.toml:9: object 1: position"

    /// Whether nothing that pushes it moves it.
    bool unyielding() const { return fixed || kinematic; }
};

/// Puts an object somewhere and gives it a velocity.
struct ThrowDescription {
    double time = 0;         ///< s, 0 to 1e5
    int object = 0;          ///< index into WorldDescription::objects; neither fixed, kinematic nor
                             ///< on a chain
    Vec3 from{0, 0, 0};      ///< m, of its centre, each −1e4 to 1e4
    Vec3 velocity{0, 0, 0};  ///< m/s, each −1e4 to 1e4
    Vec3 spin{0, 0, 0};      ///< rad/s, each −1e4 to 1e4
};

/// An object as the solvers see it: all points within `radius` of a box, its core, around its
/// centre. The core of a sphere is a point, that of a capsule a line along y.
struct Object {
    Vec3 core{0, 0, 0};      ///< m, half its edges
    double radius = 0;       ///< m
    double inverseMass = 0;  ///< 1/kg; 0: fixed or kinematic
    /// 1/(kg·m²), about its own axes; 0: fixed; 1: kinematic, whose angular momentum is its spin.
    Vec3 inverseInertia{0, 0, 0};
    double friction = 0, restitution = 0, drag = 0;
    double chain = 0;  ///< m; 0: none
    Vec3 hungFrom{0, 0, 0};

    /// m, from the centre to the farthest point.
    double reach() const { return core.norm() + radius; }
};
Object makeObject(const ObjectDescription&);

struct ObjectState {
    bool present = false;
    Vec3 position{0, 0, 0};  ///< m
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Vec3 velocity{0, 0, 0};         ///< m/s
    Vec3 angularMomentum{0, 0, 0};  ///< kg·m²/s, about its centre; what a free spin keeps
    /// kg: under standard gravity it would press as hard as others squeeze this object between them
    /// (core/object_contact.hpp).
    double load = 0;

    /// rad/s.
    Vec3 spin(const Object& object) const;
    /// m/s, of the point that is at x.
    Vec3 velocityAt(const Object& object, const Vec3& x) const {
        return velocity + spin(object).cross(x - position);
    }
    /// J.
    double kineticEnergy(const Object& object) const;
    bool operator==(const ObjectState&) const;
};
ObjectState initialState(const ObjectDescription&);
/// Turns an object freely, without torque, for `time` s: its orientation afterwards.
///
/// The spin's energy ½·Σ Lᵢ²/Iᵢ is split into the part that all axes share, a turn about the
/// angular momentum, and what the other two axes have more or less than the middle one, turns about
/// those; each is exact, and so is the whole for a body with two equal moments of inertia. Strang's
/// order of the latter two keeps the energy to second order without drift (Touma and Wisdom 1994,
/// "Lie–Poisson integrators for rigid body dynamics in the solar system"; Dullweber, Leimkuhler and
/// McLachlan 1997); twice a step, it varies by less than 0.04 % at 1,000 rad/s and h = 1/3000 s.
Eigen::Quaterniond turnedFreely(const Object& object, const ObjectState& state, double time);

/// As thrown. Its orientation is that of the description.
ObjectState thrownState(const ObjectDescription&, const ThrowDescription&);

}  // namespace sunder::core
