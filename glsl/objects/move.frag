// One fragment per object: what it gets from barriers and objects, added to what it got from cells; then a step.
#include "objects/among.glsl"

uniform sampler2DArray touchCounts;  // K
uniform sampler2DArray impulses;     // from cells: N·s; N·m·s
uniform vec3 gravity;                // m/s²

layout(location = 0) out vec4 moved[SUNDER_OBJECT_LAYERS];

int self;
ObjectRecord record;
ObjectMotion state;
vec3 linear, angular;

float touchCount(int object) { return texelFetch(touchCounts, ivec3(object, 0, 0), 0).x; }

void meet(Touch touch, vec3 velocity, int other, bool own, float restitution, float friction) {
    if (!touches(touch, velocity, stepSize)) return;
    vec2 mine = yieldOf(record, state, touch) * touchCount(self), theirs = vec2(0.0);
    if (other >= 0) theirs = yieldOf(objectRecord(other), objectMotion(other), touch) * touchCount(other);
    // The first side's before the second's, so that both get the same to the bit.
    vec2 yield_ = (own ? mine : theirs) + (own ? theirs : mine);
    vec3 impulse = touchImpulse(touch, velocity, yield_, restitution, friction, stepSize);
    if (own) impulse = -impulse;
    linear += impulse;
    angular += cross(touch.point - state.position.xyz, impulse);
}

// Product of quaternions.
vec4 times(vec4 a, vec4 b) { return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz)); }

vec4 turned(vec3 spin, float time) {
    float angle = min(length(spin) * time, 1.0);
    if (angle == 0.0) return state.orientation;
    return times(vec4(sin(0.5 * angle) * normalize(spin), cos(0.5 * angle)), state.orientation);
}

void main() {
    self = int(gl_FragCoord.x);
    record = objectRecord(self);
    state = objectMotion(self);
    linear = texelFetch(impulses, ivec3(self, 0, 0), 0).xyz;
    angular = texelFetch(impulses, ivec3(self, 0, 1), 0).xyz;
    if (state.position.w > 0.0 && record.inertia.w > 0.0) {
        meetAll(self);
        float kept = record.surface.z;
        vec3 velocity = kept * state.velocity.xyz + stepSize * gravity + record.inertia.w * linear;
        vec3 momentum = kept * state.angularMomentum.xyz + angular;
        vec3 next = state.position.xyz + stepSize * velocity;
        vec3 along = next - record.hungFrom.xyz;
        float chain = record.surface.w;
        if (chain > 0.0 && length(along) > chain) {
            vec3 outward = normalize(along);
            velocity -= max(0.0, dot(velocity, outward)) * outward;
            next = record.hungFrom.xyz + chain * outward;
        }
        // A turn by the spin in the middle of the step.
        vec4 middle = turned(spinOf(record, state.orientation, momentum), 0.5 * stepSize);
        state.orientation = normalize(turned(spinOf(record, middle, momentum), stepSize));
        state.position.xyz = next;
        state.velocity.xyz = velocity;
        state.angularMomentum.xyz = momentum;
    }
    moved[0] = state.position;
    moved[1] = state.orientation;
    moved[2] = state.velocity;
    moved[3] = state.angularMomentum;
}
