// One step of symplectic Euler for one node, then the barriers (src/core/room.hpp).
#include "shared/constants.h"
#include "shared/layout.h"
#include "physics/step.glsl"

uniform float fastestParting;  // V of src/core/overlap.hpp, m/s
uniform vec2 ground;     // x: 1 where there is a floor at y = 0; y: Coulomb coefficient
#if ROOM
uniform vec3 roomLow, roomHigh;  // m; SUNDER_NO_BARRIER away where there is none
uniform float roomFriction;
#endif

// Of x, y and z, the one on an axis. (An index would put them in memory on some GPUs, where nearly all of a step's time went.)
float along(bvec3 axis, vec3 x) { return axis.x ? x.x : axis.y ? x.y : x.z; }
vec3 withAlong(bvec3 axis, vec3 x, float other) { return mix(x, vec3(other), axis); }

// Stops what would pass a barrier on an axis; the step begins again from `bound`, the node's displacement there, or, where it was
// beyond it before, from as far on the way back as it comes. inwards: 1 where the barrier is at the low end, -1 at the high end.
void stopAt(bvec3 axis, float bound, float inwards, float friction, inout vec3 displacement, inout vec3 velocity,
            precise inout vec3 next) {
    float depth = max(0.0, inwards * (bound - along(axis, displacement)));
    float back = min(depth * (stepSize / max(kPartingTime, stepSize)), kPushShare * fastestParting * stepSize);
    bound -= inwards * (depth - back);
    if (inwards * (along(axis, next) - bound) >= 0.0) return;
    float taken = friction * max(0.0, -inwards * along(axis, velocity));
    velocity = withAlong(axis, velocity, 0.0);
    float tangential = length(velocity);
    velocity *= tangential > taken ? 1.0 - taken / tangential : 0.0;
    displacement = withAlong(axis, displacement, bound);
    next = withAlong(axis, displacement + stepSize * velocity, bound);
    if (back > 0.0) velocity = withAlong(axis, velocity, inwards * (back / stepSize));
}

#if ROOM
void stayBetween(bvec3 axis, vec3 rest, inout vec3 u, inout vec3 v, precise inout vec3 next) {
    precise float low = along(axis, roomLow) - along(axis, rest), high = along(axis, roomHigh) - along(axis, rest);
    if (along(axis, next) < low) stopAt(axis, low, 1.0, roomFriction, u, v, next);
    if (along(axis, next) > high) stopAt(axis, high, -1.0, roomFriction, u, v, next);
}
#endif

// acceleration: m/s², of the joined group, gravity and events included. rest: m; x and z count only in a room.
void integrateNode(inout vec3 displacement, inout vec3 velocity, vec3 acceleration, float drag, vec3 rest) {
    velocity = velocity * drag + stepSize * acceleration;
    precise vec3 next = displacement + stepSize * velocity;
    precise float height = rest.y + next.y;
    if (ground.x > 0.0 && height < 0.0) stopAt(bvec3(false, true, false), -rest.y, 1.0, ground.y, displacement, velocity, next);
#if ROOM
    stayBetween(bvec3(true, false, false), rest, displacement, velocity, next);
    stayBetween(bvec3(false, false, true), rest, displacement, velocity, next);
    stayBetween(bvec3(false, true, false), rest, displacement, velocity, next);
#endif
    displacement = next;
}

// force: N, on the joined group; pushed: m/s², by events.
void moveNode(vec3 force, float inverseMass, BodyRecord body, vec3 pushed, vec3 rest, inout vec3 displacement, inout vec3 velocity) {
    integrateNode(displacement, velocity, force * inverseMass + body.gravity.xyz + pushed, body.gravity.w, rest);
}
