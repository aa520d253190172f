// One fragment per object: what it gets from barriers and objects, added to what it got from cells; then a step.
#include "objects/among.glsl"
#include "objects/spin.glsl"
#include "shared/constants.h"

uniform sampler2DArray touchCounts;  // K
uniform sampler2DArray impulses;     // from cells: N·s; N·m·s
uniform vec3 gravity;                // m/s²
uniform float heaviest;              // kg, of everything together
uniform bool newWatch;               // this is the first step since objects were last looked at for rest

layout(location = 0) out vec4 moved[SUNDER_OBJECT_LAYERS];

int self;
ObjectRecord record;
ObjectMotion state;
vec3 linear, angular;
// N·s, of objects and barriers that press: sums, and those of their components' sizes.
struct Pressing {
    vec3 sum, sizes;
};
Pressing pressing, stopping;  // stopping: the parts that stop an approach

void add(inout Pressing to, vec3 impulse) {
    to.sum += impulse;
    to.sizes += abs(impulse);
}

float touchCount(int object) { return texelFetch(touchCounts, ivec3(object, 0, 0), 0).x; }

void meet(Touch touch, vec3 velocity, int other, bool own, float restitution, float friction) {
    if (!touches(touch, velocity, stepSize)) return;
    vec2 mine = yieldOf(self, record, state, touch, touchCount(self)), theirs = vec2(0.0);
    if (other >= 0) theirs = yieldOf(other, objectRecord(other), objectMotion(other), touch, touchCount(other));
    // The first side's before the second's, so that both get the same to the bit.
    vec2 yield_ = (own ? mine : theirs) + (own ? theirs : mine);
    vec3 impulse = touchImpulse(touch, velocity, yield_, restitution, friction, stepSize);
    if (own) impulse = -impulse;
    linear += impulse;
    angular += cross(touch.point - state.position.xyz, impulse);
    float approach = -dot(velocity, touch.normal);
    if (approach > kPressingSpeed) return;
    add(pressing, impulse);
    float part = min(abs(dot(impulse, touch.normal)), max(0.0, approach) / yield_.x);
    add(stopping, (own ? -part : part) * touch.normal);
}

// Holds what moves to `next` on its chain; whether it was taut. pull: its impulse, N·s.
bool hang(float share, inout vec3 velocity, inout vec3 next, out vec3 pull) {
    vec3 along = next - record.hungFrom.xyz;
    float chain = record.surface.w;
    pull = vec3(0.0);
    if (chain <= 0.0 || length(along) <= chain) return false;
    vec3 outward = normalize(along);
    float taken = max(0.0, dot(velocity, outward));
    velocity -= taken * outward;
    next = record.hungFrom.xyz + chain * outward;
    pull = -taken / (share * record.inertia.w) * outward;
    return true;
}

float against(Pressing p, vec3 other) {
    vec3 cancelled = 0.5 * (p.sizes + abs(other) - abs(p.sum + other));
    return max(cancelled.x, max(cancelled.y, cancelled.z));
}

// kg.
float squeeze(Pressing p, vec3 fromCells, vec3 fromChain) {
    return max(against(p, fromCells), against(p, fromChain)) / (stepSize * 9.81);
}

float loadAfter(vec3 fromCells, vec3 fromChain) {
    float load = state.memory.x;
    float kept = exp(-stepSize / (pressing.sizes != vec3(0.0) ? kLoadTime : kUnloadTime));
    float following = mix(squeeze(pressing, fromCells, fromChain), load, kept);
    float growing = exp(stepSize / kGrowthTime) * max(load, 1.0 / record.inertia.w);
    return min(heaviest, max(following, min(growing, squeeze(stopping, fromCells, fromChain))));
}

void main() {
    self = int(gl_FragCoord.x);
    record = objectRecord(self);
    state = objectMotion(self);
    vec3 fromCells = texelFetch(impulses, ivec3(self, 0, 0), 0).xyz;
    linear = fromCells;
    angular = texelFetch(impulses, ivec3(self, 0, 1), 0).xyz;
    pressing = stopping = Pressing(vec3(0.0), vec3(0.0));
    if (state.position.w > 0.0 && !still(self, record)) {
        meetAll(self);
        float kept = record.surface.z, share = loadShare(record, state);
        vec3 velocity = kept * state.velocity.xyz + share * (stepSize * gravity + record.inertia.w * linear);
        vec3 momentum = kept * state.angularMomentum.xyz + share * angular;
        vec3 next = state.position.xyz + stepSize * velocity;
        vec3 fromChain;
        bool hung = hang(share, velocity, next, fromChain);
        float energy = kept * kept * state.angularMomentum.w;
        if (angular != vec3(0.0)) energy = spinEnergy(record, state.orientation, momentum);
        state.orientation = turnedFreely(record, state.orientation, momentum, stepSize, energy);
        state.position.xyz = next;
        state.velocity.xyz = velocity;
        state.angularMomentum = vec4(momentum, energy);

        float spin = length(spinOf(record, state.orientation, momentum));
        float fastest = length(velocity) + spin * (length(record.shape.xyz) + record.shape.w);
        int had = (touchCount(self) > 0.0 ? SUNDER_TOUCHED : 0) | (hung ? SUNDER_HUNG : 0);
        if (!newWatch) {
            fastest = max(fastest, state.memory.y);
            had |= int(state.memory.z);
        }
        state.memory = vec4(loadAfter(fromCells, fromChain), fastest, float(had), 0.0);
        // What weighs more from now on has no more momentum for it.
        float lighter = min(1.0, loadShare(record, state) / share);
        state.velocity.xyz *= lighter;
        state.angularMomentum *= vec4(vec3(lighter), lighter * lighter);
    } else if (state.position.w > 0.0 && record.inertia.w == 0.0) {
        // Fixed, or moved by whoever puts it somewhere.
        state.position.xyz += stepSize * state.velocity.xyz;
        vec3 momentum = state.angularMomentum.xyz;
        state.orientation = turnedFreely(record, state.orientation, momentum, stepSize, state.angularMomentum.w);
    }
    moved[0] = state.position;
    moved[1] = state.orientation;
    moved[2] = state.velocity;
    moved[3] = state.angularMomentum;
    moved[4] = state.memory;
}
