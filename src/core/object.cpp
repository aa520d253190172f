#include "core/object.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunder::core {
namespace {

/// A box's edges are rounded off by this share of half its shortest edge.
constexpr double kRoundness = 0.2;

/// kg·m², about a shape's own axes, of unit mass.
Vec3 inertia(const ObjectDescription& d) {
    const Vec3 h = d.halfSize;
    const double r = h[0];
    switch (d.shape) {
        case ObjectShape::Sphere:
            return Vec3::Constant(0.4 * r * r);
        case ObjectShape::Box: {
            const Vec3 s = h.cwiseProduct(h) / 3;
            return {s[1] + s[2], s[2] + s[0], s[0] + s[1]};
        }
        case ObjectShape::Capsule:
            break;
    }
    // A cylinder of length 2·l and two half balls whose centres of mass lie 3/8·r beyond its ends.
    const double l = h[1] - r;
    const double cylinder = 2 * l / (2 * l + 4. / 3 * r), balls = 1 - cylinder;
    const double along = cylinder * 0.5 * r * r + balls * 0.4 * r * r;
    const double across =
        cylinder * (r * r / 4 + l * l / 3) + balls * (0.4 * r * r + l * l + 0.75 * l * r);
    return {across, along, across};
}

}  // namespace

Object makeObject(const ObjectDescription& d) {
    Object object;
    switch (d.shape) {
        case ObjectShape::Sphere:
            object.radius = d.halfSize[0];
            break;
        case ObjectShape::Capsule:
            object.radius = d.halfSize[0];
            object.core[1] = d.halfSize[1] - object.radius;
            break;
        case ObjectShape::Box:
            object.radius = kRoundness * d.halfSize.minCoeff();
            object.core = d.halfSize - Vec3::Constant(object.radius);
            break;
    }
    if (d.kinematic) {
        object.inverseInertia.setOnes();
    } else if (!d.fixed) {
        object.inverseMass = 1 / d.mass;
        object.inverseInertia = (d.mass * inertia(d)).cwiseInverse();
    }
    object.friction = d.friction;
    object.restitution = d.restitution;
    object.drag = d.drag;
    if (d.hungFrom && d.position) {
        object.hungFrom = *d.hungFrom;
        object.chain = (*d.position - *d.hungFrom).norm();
    }
    return object;
}

Vec3 ObjectState::spin(const Object& object) const {
    return orientation *
           object.inverseInertia.cwiseProduct(orientation.conjugate() * angularMomentum);
}

bool ObjectState::operator==(const ObjectState& other) const {
    return present == other.present && position == other.position &&
           orientation.coeffs() == other.orientation.coeffs() && velocity == other.velocity &&
           angularMomentum == other.angularMomentum && load == other.load;
}

double ObjectState::kineticEnergy(const Object& object) const {
    if (object.inverseMass == 0) return 0;
    return 0.5 * velocity.squaredNorm() / object.inverseMass +
           0.5 * angularMomentum.dot(spin(object));
}

namespace {

/// How often a step's turn is split.
constexpr int kSplits = 2;

/// The axis whose moment of inertia is the middle one.
int middleAxis(const Vec3& inverseInertia) {
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(),
                     [&](int a, int b) { return inverseInertia[a] < inverseInertia[b]; });
    return axes[1];
}

Eigen::Quaterniond turnAbout(const Vec3& axis, double angle) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

}  // namespace

Eigen::Quaterniond turnedFreely(const Object& object, const ObjectState& state, double time) {
    const double size = state.angularMomentum.norm();
    if (size == 0) return state.orientation;
    const Vec3& inverse = object.inverseInertia;
    const int middle = middleAxis(inverse), first = (middle + 1) % 3, second = (middle + 2) % 3;
    Vec3 momentum = state.orientation.conjugate() * state.angularMomentum;  // in the object's frame
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    const auto turnAlong = [&](int axis, double share) {
        const double angle = (inverse[axis] - inverse[middle]) * momentum[axis] * share;
        const Eigen::Quaterniond part = turnAbout(Vec3::Unit(axis), angle);
        turn = turn * part;
        momentum = part.conjugate() * momentum;
    };
    for (int i = 0; i < kSplits; ++i) {
        turnAlong(first, 0.5 * time / kSplits);
        turnAlong(second, time / kSplits);
        turnAlong(first, 0.5 * time / kSplits);
    }
    turn = turn * turnAbout(momentum / size, inverse[middle] * size * time);
    return (state.orientation * turn).normalized();
}

namespace {

ObjectState moving(const ObjectDescription& d, const Vec3& position, const Vec3& velocity,
                   const Vec3& spin) {
    ObjectState state;
    state.present = true;
    state.position = position;
    state.orientation = d.orientation;
    if (d.fixed) return state;
    state.velocity = velocity;
    state.angularMomentum = spin;
    if (d.kinematic) return state;
    state.angularMomentum =
        d.orientation * (d.mass * inertia(d)).cwiseProduct(d.orientation.conjugate() * spin).eval();
    return state;
}

}  // namespace

ObjectState initialState(const ObjectDescription& d) {
    return d.position ? moving(d, *d.position, d.velocity, d.spin) : ObjectState{};
}

ObjectState thrownState(const ObjectDescription& d, const ThrowDescription& t) {
    return moving(d, t.from, t.velocity, t.spin);
}

}  // namespace sunder::core
