// One step of symplectic Euler for one node, then the barriers (src/core/room.hpp).
#include "shared/constants.h"
#include "shared/layout.h"

uniform float stepSize;        // h, s
uniform float fastestParting;  // V of src/core/overlap.hpp, m/s
uniform vec2 ground;     // x: 1 where there is a floor at y = 0; y: Coulomb coefficient
#if ROOM
uniform vec3 roomLow, roomHigh;  // m; SUNDER_NO_BARRIER away where there is none
uniform float roomFriction;
#endif

// Stops what would pass a barrier on an axis, a constant wherever this is called; the step begins again from `bound`, the node's
// displacement there, or, where it was beyond it before, from as far on the way back as it comes. inwards: 1 where the barrier
// is at the low end, -1 at the high end.
void stopAt(int axis, float bound, float inwards, float friction, inout vec3 displacement, inout vec3 velocity,
            precise inout vec3 next) {
    float depth = max(0.0, inwards * (bound - displacement[axis]));
    float back = min(depth * (stepSize / max(kPartingTime, stepSize)), kPushShare * fastestParting * stepSize);
    bound -= inwards * (depth - back);
    if (inwards * (next[axis] - bound) >= 0.0) return;
    float taken = friction * max(0.0, -inwards * velocity[axis]);
    velocity[axis] = 0.0;
    float tangential = length(velocity);
    velocity *= tangential > taken ? 1.0 - taken / tangential : 0.0;
    displacement[axis] = bound;
    next = displacement + stepSize * velocity;
    next[axis] = bound;
    if (back > 0.0) velocity[axis] = inwards * (back / stepSize);
}

#if ROOM
void stayBetween(int axis, vec3 rest, inout vec3 u, inout vec3 v, precise inout vec3 next) {
    precise float low = roomLow[axis] - rest[axis], high = roomHigh[axis] - rest[axis];
    if (next[axis] < low) stopAt(axis, low, 1.0, roomFriction, u, v, next);
    if (next[axis] > high) stopAt(axis, high, -1.0, roomFriction, u, v, next);
}
#endif

// acceleration: m/s², of the joined group, gravity and events included. rest: m; x and z count only in a room.
void integrateNode(inout vec3 displacement, inout vec3 velocity, vec3 acceleration, float drag, vec3 rest) {
    velocity = velocity * drag + stepSize * acceleration;
    precise vec3 next = displacement + stepSize * velocity;
    precise float height = rest.y + next.y;
    if (ground.x > 0.0 && height < 0.0) stopAt(1, -rest.y, 1.0, ground.y, displacement, velocity, next);
#if ROOM
    stayBetween(0, rest, displacement, velocity, next);
    stayBetween(2, rest, displacement, velocity, next);
    stayBetween(1, rest, displacement, velocity, next);
#endif
    displacement = next;
}
