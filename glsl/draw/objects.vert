// Rounded boxes (src/core/object.hpp) without attributes: a sphere made from a cube, whose octants stand apart by the core.
// Each face of the cube is a grid whose middle lines are there twice, once for the octants on either side: the quads between
// the two copies are the flat faces and the quarter cylinders, and nothing where the core has no extent. An instance is an
// object, or a link of a chain.
#include "shared/layout.h"

uniform samplerBuffer objects;
uniform samplerBuffer places;  // of every object its position, then of every object its orientation
uniform int objectCount;
uniform int segments;          // along an octant's edge
uniform int chained;           // −1: instances are objects; otherwise links of this object's chain
uniform int links;
uniform mat4 viewProjection;

#ifdef FLAT
#define VARYING flat
#else
#define VARYING
#endif
out vec3 position;           // m, world
VARYING out vec3 normal;
out vec3 direction;          // the normal, in the object's own axes
flat out float seams;        // 1 on a round object, whose spin nothing else would show
flat out vec3 baseColour;    // linear RGB
#ifdef FLAT
flat out int paintedCell;    // draw/wire.frag reads it where cells are painted; objects are not
#endif

struct RoundedBox {
    vec3 centre;
    mat3 axes;
    vec3 core;     // m, half its edges
    float radius;  // m
};

mat3 rotation(vec4 q) {
    vec3 v = q.xyz;
    mat3 m;
    for (int axis = 0; axis < 3; ++axis) {
        vec3 e = vec3(0.0);
        e[axis] = 1.0;
        m[axis] = e + 2.0 * cross(v, cross(v, e) + q.w * e);
    }
    return m;
}

RoundedBox objectBox(int object) {
    vec4 shape = texelFetch(objects, SUNDER_OBJECT_TEXELS * object);
    vec4 orientation = texelFetch(places, objectCount + object);
    return RoundedBox(texelFetch(places, object).xyz, rotation(orientation), shape.xyz, shape.w);
}

// Flat links between the hook and the object's centre, every other one turned by a quarter. As thick as suits the object.
RoundedBox linkBox(int link) {
    vec4 shape = texelFetch(objects, SUNDER_OBJECT_TEXELS * chained);
    vec3 hook = texelFetch(objects, SUNDER_OBJECT_TEXELS * chained + 3).xyz;
    vec3 way = texelFetch(places, chained).xyz - hook;
    float stretch = max(length(way), 1e-6);
    vec3 along = way / stretch;
    // The x axis, turned as a chain that hung straight down has been: it never jumps while the chain swings.
    const vec3 DOWN = vec3(0.0, -1.0, 0.0);
    vec3 across = vec3(1.0, 0.0, 0.0) - along.x / max(1.0 + dot(along, DOWN), 1e-6) * (along + DOWN);
    vec3 third = cross(across, along);
    float thickness = 0.05 * (min(shape.x, min(shape.y, shape.z)) + shape.w);
    // Each reaches a little into its neighbours.
    float halfLength = 0.5 * stretch / float(links) + thickness;
    mat3 axes = (link & 1) == 0 ? mat3(across, along, third) : mat3(third, along, -across);
    return RoundedBox(hook + way * (float(link) + 0.5) / float(links), axes, vec3(2.0 * thickness, halfLength, 0.0),
                      thickness);
}

void main() {
    int object = chained < 0 ? gl_InstanceID : chained;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside every view
    position = normal = direction = baseColour = vec3(0.0);
    seams = 0.0;
#ifdef FLAT
    paintedCell = -1;
#endif
    if (texelFetch(places, object).w == 0.0) return;

    // Two triangles a quad, anticlockwise as (axis, u, v) is right-handed, and the other way round on the negative side.
    int quad = gl_VertexID / 6, corner = gl_VertexID % 6;
    int row = 2 * segments + 1;
    int face = quad / (row * row), axis = face >> 1;
    float side = float(2 * (face & 1) - 1);
    ivec2 turn = ivec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
    ivec2 place = ivec2(quad % row, (quad / row) % row) + (side > 0.0 ? turn : turn.yx);

    ivec3 order = ivec3(axis, (axis + 1) % 3, (axis + 2) % 3);
    bvec2 upper = greaterThan(place, ivec2(segments));
    // Almost equal angles, not equal lengths on the cube: quads of about one size. Exactly 1 at the cube's edges, and in
    // one order whichever face it is: neighbours must agree to the bit, or there are cracks.
    vec2 t = (vec2(place) - vec2(upper) - float(segments)) / float(segments);
    vec3 sphere = vec3(side, t * (0.75 + 0.25 * t * t));
    vec3 octant = vec3(side, 2.0 * vec2(upper) - 1.0), signs;
    for (int i = 0; i < 3; ++i) {
        direction[order[i]] = sphere[i];
        signs[order[i]] = octant[i];
    }
    direction = normalize(direction);

    RoundedBox box = chained < 0 ? objectBox(gl_InstanceID) : linkBox(gl_InstanceID);
    position = box.centre + box.axes * (box.core * signs + box.radius * direction);
    normal = box.axes * direction;
    gl_Position = viewProjection * vec4(position, 1.0);
    baseColour = texelFetch(objects, SUNDER_OBJECT_TEXELS * object + 4).rgb;
    if (chained < 0 && box.core.x == 0.0) seams = 1.0;
}
