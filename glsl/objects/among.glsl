// What an object touches besides cells: barriers (src/core/room.hpp) and other objects.
#include "objects/motion.glsl"

uniform float stepSize;        // s
uniform float settlingSpeed;   // m/s
uniform float fastestParting;  // m/s
uniform vec2 ground;           // x: 1 where there is a floor at y = 0; y: Coulomb coefficient
#if ROOM
uniform vec3 roomLow, roomHigh;  // m; SUNDER_NO_BARRIER away where there is none
uniform float roomFriction;
#endif

// Defined by who includes this: `self` is the first (own = true) or the second side of a touch; other: −1, a barrier.
void meet(Touch touch, vec3 velocity, int other, bool own, float restitution, float friction);

// A corner of a box's core; repeated: there is one with a lower number in the same place.
RoundedBox cornerBox(RoundedBox box, int corner, out bool repeated) {
    bvec3 high = bvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    repeated = (high.x && box.half_.x == 0.0) || (high.y && box.half_.y == 0.0) || (high.z && box.half_.z == 0.0);
    box.centre += box.axes * mix(-box.half_, box.half_, high);
    box.half_ = vec3(0.0);
    return box;
}

// Overlaps part slowly. share: the smaller one of both sides' loadShare().
void settle(inout Touch touch, float share) {
    if (touch.gap < 0.0) touch.gap *= max(kLoadedDepth, share);
    float fastest = kPushShare * fastestParting;
    limitDepth(touch, share < 1.0 ? min(settlingSpeed, fastest) : fastest, stepSize);
}

// towards: the unit vector from the object to a barrier that lies `place` along it.
void meetBarrier(RoundedBox point, ObjectRecord record, ObjectMotion state, vec3 towards, float place, float friction) {
    Touch touch = Touch(towards, point.centre + point.radius * towards, place - dot(towards, point.centre) - point.radius);
    settle(touch, loadShare(record, state));
    meet(touch, -velocityAt(record, state, touch.point), -1, true, record.surface.y, 0.5 * (record.surface.x + friction));
}

void meetBarriers(ObjectRecord record, ObjectMotion state) {
    RoundedBox box = boxOf(record, state);
    for (int corner = 0; corner < 8; ++corner) {
        bool repeated;
        RoundedBox point = cornerBox(box, corner, repeated);
        if (repeated) continue;
        if (ground.x > 0.0) meetBarrier(point, record, state, vec3(0.0, -1.0, 0.0), 0.0, ground.y);
#if ROOM
        meetBarrier(point, record, state, vec3(-1.0, 0.0, 0.0), -roomLow.x, roomFriction);
        meetBarrier(point, record, state, vec3(1.0, 0.0, 0.0), roomHigh.x, roomFriction);
        meetBarrier(point, record, state, vec3(0.0, 0.0, -1.0), -roomLow.z, roomFriction);
        meetBarrier(point, record, state, vec3(0.0, 0.0, 1.0), roomHigh.z, roomFriction);
        meetBarrier(point, record, state, vec3(0.0, 1.0, 0.0), roomHigh.y, roomFriction);
#endif
    }
}

void meetPair(int self, int other) {
    int a = min(self, other), b = max(self, other);
    ObjectRecord first = objectRecord(a), second = objectRecord(b);
    ObjectMotion stateA = objectMotion(a), stateB = objectMotion(b);
    if (stateB.position.w * stateA.position.w == 0.0 || (still(a, first) && still(b, second))) return;
    RoundedBox boxA = boxOf(first, stateA), boxB = boxOf(second, stateB);
    vec3 closing = stateB.velocity.xyz - stateA.velocity.xyz;
    float share = min(loadShare(first, stateA), loadShare(second, stateB));
    // 0: the two as they are; 1–8: corners of the first; 9–16: of the second.
    bool round_ = boxA.half_ == vec3(0.0) || boxB.half_ == vec3(0.0);
    for (int i = 0; i < (round_ ? 1 : 17); ++i) {
        RoundedBox from = boxA, to = boxB;
        bool repeated = false;
        if (i > 8) to = cornerBox(boxB, i - 9, repeated);
        else if (i > 0) from = cornerBox(boxA, i - 1, repeated);
        if (repeated) continue;
        Touch touch = sweptTouch(from, to, closing, stepSize);
        bool deep = i == 0 && touch.gap <= -boxA.radius - boxB.radius;
        if (deep) touch = deepTouch(boxA, boxB);
        settle(touch, share);
        vec3 velocity = velocityAt(second, stateB, touch.point) - velocityAt(first, stateA, touch.point);
        meet(touch, velocity, other, self == a, 0.5 * (first.surface.y + second.surface.y),
             0.5 * (first.surface.x + second.surface.x));
        if (deep) break;
    }
}

void meetAll(int self) {
    ObjectRecord record = objectRecord(self);
    ObjectMotion state = objectMotion(self);
    if (state.position.w == 0.0) return;
    if (!still(self, record)) meetBarriers(record, state);
    for (int other = 0; other < objectCount; ++other)
        if (other != self) meetPair(self, other);
}
