#include "core/object.hpp"

#include <numbers>

namespace sunder {
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
    if (!d.fixed) {
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

double ObjectState::kineticEnergy(const Object& object) const {
    if (object.inverseMass == 0) return 0;
    return 0.5 * velocity.squaredNorm() / object.inverseMass +
           0.5 * angularMomentum.dot(spin(object));
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

}  // namespace sunder
