// Objects: what they are and how they move.
#include "physics/objects.glsl"

uniform samplerBuffer objects;  // SUNDER_OBJECT_TEXELS per object
uniform sampler2DArray motion;  // a texel per object, layers of ObjectMotion
uniform samplerBuffer sleepers;  // x: 1 where the object is asleep
uniform int objectCount;

ObjectRecord objectRecord(int object) {
    int first = SUNDER_OBJECT_TEXELS * object;
    return ObjectRecord(texelFetch(objects, first), texelFetch(objects, first + 1), texelFetch(objects, first + 2),
                        texelFetch(objects, first + 3), texelFetch(objects, first + 4));
}

ObjectMotion objectMotion(int object) {
    return ObjectMotion(texelFetch(motion, ivec3(object, 0, 0), 0), texelFetch(motion, ivec3(object, 0, 1), 0),
                        texelFetch(motion, ivec3(object, 0, 2), 0), texelFetch(motion, ivec3(object, 0, 3), 0),
                        texelFetch(motion, ivec3(object, 0, 4), 0));
}

bool asleep(int object) { return texelFetch(sleepers, object).x > 0.0; }
// It does not yield: fixed, or asleep.
bool still(int object, ObjectRecord record) { return record.inertia.w == 0.0 || asleep(object); }

// Columns: the object's axes. q: unit quaternion, w its real part.
mat3 axesOf(vec4 q) {
    vec3 d = q.xyz * q.xyz;
    float xy = q.x * q.y, yz = q.y * q.z, zx = q.z * q.x;
    vec3 w = q.w * q.xyz;
    return mat3(1.0 - 2.0 * (d.y + d.z), 2.0 * (xy + w.z), 2.0 * (zx - w.y), 2.0 * (xy - w.z), 1.0 - 2.0 * (d.x + d.z),
                2.0 * (yz + w.x), 2.0 * (zx + w.y), 2.0 * (yz - w.x), 1.0 - 2.0 * (d.x + d.y));
}

RoundedBox boxOf(ObjectRecord record, ObjectMotion state) {
    return RoundedBox(state.position.xyz, axesOf(state.orientation), record.shape.xyz, record.shape.w);
}

// rad/s.
vec3 spinOf(ObjectRecord record, vec4 orientation, vec3 angularMomentum) {
    mat3 axes = axesOf(orientation);
    return axes * (record.inertia.xyz * (angularMomentum * axes));
}

// m/s, of the object's point at x.
vec3 velocityAt(ObjectRecord record, ObjectMotion state, vec3 x) {
    return state.velocity.xyz +
           cross(spinOf(record, state.orientation, state.angularMomentum.xyz), x - state.position.xyz);
}

// m/m' of an object, 1 at most.
float loadShare(ObjectRecord record, ObjectMotion state) {
    return 1.0 / max(1.0, kLoadMargin * state.memory.x * record.inertia.w);
}

// What an object gives way per impulse, 1/kg, with its share of the mass for each of `touches_` touches: along the normal, across it.
vec2 yieldOf(int object, ObjectRecord record, ObjectMotion state, Touch touch, float touches_) {
    if (still(object, record)) return vec2(0.0);
    vec3 arm = touch.point - state.position.xyz;
    vec3 turned = cross(arm, touch.normal) * axesOf(state.orientation);
    vec3 inertia = record.inertia.xyz;
    vec2 whole = record.inertia.w +
                 vec2(dot(turned, inertia * turned), dot(arm, arm) * max(inertia.x, max(inertia.y, inertia.z)));
    return whole * (loadShare(record, state) * touches_);
}
