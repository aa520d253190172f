// A cell and an object that may touch: one point. WHAT: COUNT adds one to the object's touches, REACTION the impulse on the
// object, FORCE the forces on the cell's corners.
#define COUNT 0
#define REACTION 1
#define FORCE 2
#include "objects/cell.glsl"

uniform samplerBuffer strengths;  // w: friction
uniform float stepSize;           // s
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
#endif

// Half a sphere's share of a cell along each axis: contactProxy() in src/core/contact.cpp.
vec3 placeMargin(vec3 edges) {
    float shortest = min(edges.x, min(edges.y, edges.z));
    vec3 count = clamp(floor(min(edges / shortest, 8.0) + 0.5), 1.0, 8.0);
    for (int i = 0; i < 16; ++i) {
        if (count.x * count.y * count.z <= 8.0) break;
        float most = max(count.x, max(count.y, count.z));
        if (count.x == most) count.x -= 1.0;
        else if (count.y == most) count.y -= 1.0;
        else count.z -= 1.0;
    }
    return 0.5 / count;
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
#endif
    int cell = pair.x;
    uvec4 record = cellRecord(cell);
    vec3 edges = bodyRecord(bodyOf(record)).cellSize.xyz;
    CellMotion nodes_ = cellMotion(cell);
    RoundedBox box = cellBox(nodes_, edges);
    vec3 mean = meanOf(nodes_.velocity), margin = placeMargin(edges);

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
        Touch its = sweptTouch(boxOf(kind, state), box, mean - state.velocity.xyz, stepSize);
        float itsWeights[8];
        cornerWeights(box, margin, its.point, itsWeights);
        vec3 v = -velocityAt(kind, state, its.point);
        float sum = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            v += itsWeights[corner] * nodes_.velocity[corner];
            sum += itsWeights[corner] * itsWeights[corner];
        }
        bool does = touches(its, v, stepSize);
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
    vec2 yield_ = yieldOf(kind, state, touch) * texelFetch(touchCounts, ivec3(object, 0, 0), 0).x;
    yield_ += squares / cornerMass(record) * cellTouches;
    float restitution = float(record.x >> SUNDER_CELL_RESTITUTION_BIT) / 255.0;
    vec3 impulse =
        touchImpulse(touch, velocity, yield_, 0.5 * (kind.surface.y + restitution),
                     0.5 * (kind.surface.x + texelFetch(strengths, cell).w), stepSize);
#if WHAT == REACTION
    linear = -impulse;
    angular = cross(touch.point - state.position.xyz, linear);
    show(ivec2(object, 0));
#else
    for (int corner = 0; corner < 8; ++corner) given.force[corner] = weights[corner] / stepSize * impulse;
    show(texelAddress(cell));
#endif
#endif
}
