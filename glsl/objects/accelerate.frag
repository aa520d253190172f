// One fragment per object: what the events of every body add to its motion as a step begins, by the eight points of
// src/cpu/object_push.hpp.
#include "objects/spin.glsl"
#include "physics/events.glsl"

uniform float stepSize;     // s
uniform float stepInFrame;  // number of the step

layout(location = 0) out vec4 moved[SUNDER_OBJECT_LAYERS];

void main() {
    int self = int(gl_FragCoord.x);
    ObjectRecord record = objectRecord(self);
    ObjectMotion state = objectMotion(self);
    if (state.position.w > 0.0 && !still(self, record)) {
        RoundedBox box = boxOf(record, state);
        vec3 half_ = inversesqrt(3.0) * (box.half_ + box.radius);
        vec3 acceleration = vec3(0.0), torque = vec3(0.0);  // torque: for each kilogram
        for (int point = 0; point < 8; ++point) {
            bvec3 high = bvec3(point & 1, point >> 1 & 1, point >> 2 & 1);
            vec3 arm = box.axes * mix(-half_, half_, high);
            vec3 share = 0.125 * blastAcceleration(box.centre + arm, stepInFrame);
            acceleration += share;
            torque += cross(arm, share);
        }
        // objects/move.frag lets motion fade before it adds.
        float gain = loadShare(record, state) * stepSize / record.surface.z;
        state.velocity.xyz += gain * acceleration;
        if (torque != vec3(0.0)) {
            vec3 momentum = state.angularMomentum.xyz + gain / record.inertia.w * torque;
            state.angularMomentum = vec4(momentum, spinEnergy(record, state.orientation, momentum));
        }
    }
    moved[0] = state.position;
    moved[1] = state.orientation;
    moved[2] = state.velocity;
    moved[3] = state.angularMomentum;
    moved[4] = state.memory;
}
