// A cell and an object that may touch: one point. WHAT: COUNT adds one to the object's touches, REACTION the impulse on the
// object, FORCE the forces on the cell's corners, IMPULSE how hard it is pushed.
#define COUNT 0
#define REACTION 1
#define FORCE 2
#define IMPULSE 3
#include "objects/cell.glsl"
#include "contact/joined.glsl"

uniform samplerBuffer strengths;  // w: friction
uniform float stepSize;           // s
uniform float fastestParting;     // m/s
uniform ivec2 targetSize;         // texels
#if WHAT != COUNT
uniform sampler2DArray touchCounts;  // K of an object
#endif

in ivec4 pair;  // objects/search.geom

#if WHAT == REACTION
flat out vec3 linear;   // N·s
flat out vec3 angular;  // N·m·s, about the object's centre
#elif WHAT == FORCE
out CellForces {
    flat vec3 force[8];  // N
    flat int cell;
} given;
#elif WHAT == IMPULSE
flat out float impulse;  // N·s
flat out int object_;
#endif

// Where the centre or the core of an object is in a body: src/core/object_contact.hpp.
void pushOut(inout Touch touch, RoundedBox object, RoundedBox box, int cell, uvec4 record, BodyRecord body) {
    vec3 below = (vec3(cellCoordinates(cell, ivec4(body.lattice))) + 0.5) * body.cellSize.xyz;
    vec3 above = body.lattice.xyz * body.cellSize.xyz - below;
    float depth;
    vec3 way = wayOut(box, below, above, object.centre, depth);
    if (depth <= 0.0 && touch.gap > -object.radius - box.radius) return;
    if (!whole(linkMasksOf(cell), record.x)) return;
    touch.normal = -way;
    touch.gap = min(touch.gap, -depth);
}

void hide() { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); }

void show(ivec2 texel) { gl_Position = vec4(2.0 * (vec2(texel) + 0.5) / vec2(targetSize) - 1.0, 0.0, 1.0); }

void main() {
    hide();
    gl_PointSize = 1.0;
#if WHAT == REACTION
    linear = angular = vec3(0.0);
#elif WHAT == FORCE
    for (int corner = 0; corner < 8; ++corner) given.force[corner] = vec3(0.0);
    given.cell = pair.x;
#elif WHAT == IMPULSE
    impulse = 0.0;
    object_ = 0;
#endif
    int cell = pair.x;
    uvec4 record = cellRecord(cell);
    BodyRecord body = bodyRecord(bodyOf(record));
    CellMotion nodes_ = cellMotion(cell);
    RoundedBox box = cellBox(nodes_, body.cellSize.xyz);
    vec3 mean = meanOf(nodes_.velocity), margin = 0.5 / sphereCounts(body);  // half a sphere's share of the cell

    bool stillCell = true;
    for (int corner = 0; corner < 8; ++corner) stillCell = stillCell && nodes_.velocity[corner] == vec3(0.0);

    // The touches of all objects with this cell are counted, this entry's is kept.
    float cellTouches = 0.0;
    Touch touch;
    vec3 velocity;
    float weights[8];
    float squares;
    bool touching = false;
    int object = 0;
    for (int slot = 0; slot < 8; ++slot) {
        uint number = uint(slot < 4 ? pair.y : pair.z) >> uint(8 * (slot & 3)) & 255u;
        if (number == 0u) break;
#if WHAT == COUNT
        if (slot != pair.w) continue;  // what the others do does not matter
#endif
        int other = int(number) - 1;
        ObjectRecord kind = objectRecord(other);
        ObjectMotion state = objectMotion(other);
        RoundedBox thing = boxOf(kind, state);
        Touch its = sweptTouch(thing, box, mean - state.velocity.xyz, stepSize);
        if (its.gap < 0.0) pushOut(its, thing, box, cell, record, body);
        limitDepth(its, kPushShare * fastestParting, stepSize);
        float itsWeights[8];
        cornerWeights(box, margin, its.point, itsWeights);
        vec3 v = -velocityAt(kind, state, its.point);
        float sum = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            v += itsWeights[corner] * nodes_.velocity[corner];
            sum += itsWeights[corner] * itsWeights[corner];
        }
        bool does = touches(its, v, stepSize) && !(stillCell && asleep(other));  // or they sleep together
        if (does) cellTouches += 1.0;
        if (slot == pair.w) {
            touch = its;
            velocity = v;
            weights = itsWeights;
            squares = sum;
            touching = does;
            object = other;
        }
    }
    if (!touching) return;
#if WHAT == COUNT
    show(ivec2(object, 0));
#else
    ObjectRecord kind = objectRecord(object);
    ObjectMotion state = objectMotion(object);
    vec2 yield_ = yieldOf(object, kind, state, touch, texelFetch(touchCounts, ivec3(object, 0, 0), 0).x);
    yield_ += squares / cornerMass(record) * cellTouches;
    float restitution = float(record.x >> SUNDER_CELL_RESTITUTION_BIT) / 255.0;
    vec3 given_ =
        touchImpulse(touch, velocity, yield_, 0.5 * (kind.surface.y + restitution),
                     0.5 * (kind.surface.x + texelFetch(strengths, cell).w), stepSize);
#if WHAT == REACTION
    linear = -given_;
    angular = cross(touch.point - state.position.xyz, linear);
    show(ivec2(object, 0));
#elif WHAT == FORCE
    for (int corner = 0; corner < 8; ++corner) given.force[corner] = weights[corner] / stepSize * given_;
    show(texelAddress(cell));
#else
    impulse = length(given_);
    object_ = object;
    if (impulse > 0.0) show(texelAddress(cell) * ivec2(targetSize.x >> textureShift, 1));  // its first sphere
#endif
#endif
}
