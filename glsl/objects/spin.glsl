// A free turn, as turnedFreely() in src/core/object.cpp makes it. In single precision an orientation is rounded once a step: small turns
// are kept as what they differ from none and joined first. Its rounding would still add up to a percent in a minute for a thin rod, so the
// energy is put back to what it was.
#include "objects/motion.glsl"

// Product of quaternions.
vec4 times(vec4 a, vec4 b) { return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz)); }

// One turn after another; they are quaternions less the identity.
vec4 joinedTurns(vec4 a, vec4 b) { return a + b + times(a, b); }

// rad, about a unit axis; less the identity.
vec4 turnAbout(vec3 axis, float angle) {
    float quarter = sin(0.25 * angle);
    return vec4(sin(0.5 * angle) * axis, -2.0 * quarter * quarter);
}

// The vector as it is seen after the turn.
vec3 seenFrom(vec4 turn, vec3 v) {
    vec3 t = 2.0 * cross(v, turn.xyz);
    return v + (1.0 + turn.w) * t + cross(t, turn.xyz);
}

void turnAlong(int axis, float share, vec3 more, inout vec3 momentum, inout vec4 turn) {
    vec3 unit = vec3(axis == 0, axis == 1, axis == 2);
    vec4 part = turnAbout(unit, dot(more * momentum, unit) * share);
    turn = joinedTurns(turn, part);
    momentum = seenFrom(part, momentum);
}

// The axis whose moment of inertia is the middle one.
int middleAxis(vec3 inverse) {
    float low = min(inverse.x, min(inverse.y, inverse.z)), high = max(inverse.x, max(inverse.y, inverse.z));
    float middle = inverse.x + inverse.y + inverse.z - low - high;
    vec3 off = abs(inverse - middle);
    return off.x <= off.y && off.x <= off.z ? 0 : off.y <= off.z ? 1 : 2;
}

vec4 applied(vec4 orientation, vec4 turn) {
    vec4 q = orientation + times(orientation, turn);
    return q + (0.5 - 0.5 * dot(q, q)) * q;
}

// J.
float spinEnergy(ObjectRecord record, vec4 orientation, vec3 angularMomentum) {
    vec3 momentum = angularMomentum * axesOf(orientation);
    return 0.5 * dot(momentum, record.inertia.xyz * momentum);
}

// The orientation near this one with that energy: a turn along its gradient on the sphere of constant angular momentum. Near an axis of
// inertia there is hardly any, and nothing is lost there.
vec4 withEnergy(ObjectRecord record, vec4 orientation, vec3 angularMomentum, float energy) {
    vec3 momentum = angularMomentum * axesOf(orientation), spin = record.inertia.xyz * momentum;
    vec3 gradient = cross(momentum, spin);
    float steepness = dot(gradient, gradient);
    if (steepness <= 1.0e-6 * dot(momentum, momentum) * dot(spin, spin)) return orientation;
    vec3 turn = (0.5 * dot(momentum, spin) - energy) / steepness * gradient;
    float angle = length(turn);
    if (angle > 0.01) turn *= 0.01 / angle;
    return applied(orientation, vec4(0.5 * turn, 0.0));
}

vec4 turnedFreely(ObjectRecord record, vec4 orientation, vec3 angularMomentum, float time, float energy) {
    float size = length(angularMomentum);
    if (size == 0.0) return orientation;
    vec3 inverse = record.inertia.xyz, momentum = angularMomentum * axesOf(orientation);
    int middle = middleAxis(inverse), first = (middle + 1) % 3, second = (middle + 2) % 3;
    float shared_ = middle == 0 ? inverse.x : middle == 1 ? inverse.y : inverse.z;
    vec3 more = inverse - shared_;
    vec4 turn = vec4(0.0);
    for (int i = 0; i < 2; ++i) {
        turnAlong(first, 0.25 * time, more, momentum, turn);
        turnAlong(second, 0.5 * time, more, momentum, turn);
        turnAlong(first, 0.25 * time, more, momentum, turn);
    }
    turn = joinedTurns(turn, turnAbout(momentum / size, shared_ * size * time));
    return withEnergy(record, applied(orientation, turn), angularMomentum, energy);
}
