// A vertex of the mesh that is seen (src/surface/display_mesh.hpp; thesis, chapter 8): bound by barycentric coordinates to a
// tetrahedron of the simulation mesh, straight from the solver's node buffer. displayedPosition() is the same on the CPU.
#include "shared/layout.h"
#include "shared/display_vertex.h"
#include "physics/links.glsl"

layout(location = 0) in vec3 start;   // m, world, at rest
layout(location = 1) in uvec3 owner;  // cell, code, owner of the bond through the face

uniform usamplerBuffer cells;
uniform samplerBuffer bodies;
uniform samplerBuffer damage;  // of the bonds that each cell owns
uniform samplerBuffer displacements;
uniform samplerBuffer rest;
// Texels from one cell's damage to the next; of displacements from one cell's to the next, from one corner's to the next.
#ifdef HOST_VERTEX
const int damageStride = DAMAGE_STRIDE;
const ivec2 displacementStrides = ivec2(CELL_STRIDE, CORNER_STRIDE);
#else
uniform int damageStride;
uniform ivec2 displacementStrides;
uniform mat4 viewProjection;
#endif

// Of a host's shader that calls this as a function (draw/host_vertex.glsl), nothing goes on to another stage.
#ifdef HOST_VERTEX
#define PASSED
#define PASSED_FLAT
#else
#define PASSED out
#define PASSED_FLAT flat out
#endif
#ifndef DEPTH_ONLY
PASSED_FLAT int paintedCell;     // for draw/paint.glsl
PASSED vec3 position;            // m, world
PASSED vec3 normal;              // of a body's outside, smooth, any length; zero on torn faces, which are flat
PASSED vec3 place;               // m, at rest, from the body's origin along its own axes
PASSED_FLAT uint surfaceLaw;
PASSED_FLAT float seed;          // 0 to 1, per body
PASSED_FLAT float insideFace;    // 1 on a face that a broken bond has bared
PASSED_FLAT float boundaryFace;  // 1 on one between two clusters
#endif
#ifdef SURFACE
// For a host's own shaders: `normal` has length 1, on torn faces too, where it is the cell's; and the way in which the first
// coordinate of textures grows, across the face at rest (src/sim_gl/deformed_mesh.cpp). w: sign of the bitangent.
PASSED vec4 tangent;
#endif

#ifndef HOST_VERTEX
// Depths must be the same to the bit in every pass that draws glass.
invariant gl_Position;
#endif

struct Lattice {
    ivec3 strides;  // from a cell to its neighbours
    vec3 cellSize;  // m
    int firstCell;
#ifdef TURNED
    mat3 axes;  // the body's own in the world, at rest
#endif
};

Lattice latticeOf(int body) {
    vec4 lattice = texelFetch(bodies, SUNDER_BODY_TEXELS * body);
    ivec3 size = ivec3(lattice.xyz);
    ivec3 strides = ivec3(1, size.x, size.x * size.y);
    vec3 cellSize = texelFetch(bodies, SUNDER_BODY_TEXELS * body + 1).xyz;
#ifdef TURNED
    int axes = SUNDER_BODY_TEXELS * body + SUNDER_BODY_AXES;
    return Lattice(strides, cellSize, int(lattice.w), mat3(texelFetch(bodies, axes).xyz, texelFetch(bodies, axes + 1).xyz,
                                                           texelFetch(bodies, axes + 2).xyz));
#else
    return Lattice(strides, cellSize, int(lattice.w));
#endif
}

// From the body's own axes to the world's, and back.
vec3 inWorld(Lattice lattice, vec3 own) {
#ifdef TURNED
    return lattice.axes * own;
#else
    return own;
#endif
}
vec3 alongAxes(Lattice lattice, vec3 way) {
#ifdef TURNED
    return way * lattice.axes;
#else
    return way;
#endif
}

// Octants around the vertex whose cells hang together with its own, as eight bits. `low`: cell of octant 0.
uint groupAround(uint planes, uint own, int low, ivec3 strides) {
    if (planes == 0u) return 1u << own;
    uvec3 held = uvec3(0u);
    for (uint octant = 0u; octant < 7u; ++octant) {
        if ((octant & ~planes) != 0u || octant == planes) continue;
        ivec3 at = ivec3(octant & 1u, octant >> 1 & 1u, octant >> 2);
        vec3 broken = texelFetch(damage, damageStride * (low + at.x * strides.x + at.y * strides.y + at.z * strides.z)).xyz;
        for (int axis = 0; axis < 3; ++axis) {
            uint bit = 1u << uint(axis);
            if ((planes & bit) != 0u && (octant & bit) == 0u && broken[axis] < 1.0) held[axis] |= 1u << octant;
        }
    }
    return linkMask(held, int(own));
}

vec3 displacementOf(int c, int corner) {
    return texelFetch(displacements, displacementStrides.x * c + displacementStrides.y * corner).xyz;
}

// Displacement at u, 0 to 1 in the cell c: of the tetrahedron that u lies in, or nearest to.
vec3 displacementAt(int c, vec3 u) {
    uint odd = (texelFetch(cells, c).r & SUNDER_CELL_ODD) != 0u ? 1u : 0u;
    // Corner tetrahedra have their apex at 1, 2, 4, 7, in odd cells at 0, 3, 5, 6; three steps along the axes lead to their
    // other corners.
    int apex = 0;
    vec3 steps = vec3(0.0);
    float nearest = 1e30;
    for (int i = 0; i < 4; ++i) {
        int corner = i == 0 ? 0 : 7 - (8 >> i);  // 0, 3, 5, 6
        if (odd == 0u) corner ^= 7;              // 7, 4, 2, 1
        vec3 s = mix(u, 1.0 - u, bvec3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0));
        float far = s.x + s.y + s.z;
        if (far > nearest - 1e-4) continue;  // of two equally near ones the first, lest rounding decide
        nearest = far;
        apex = corner;
        steps = s;
    }
    if (nearest < 1.0)
        return (1.0 - nearest) * displacementOf(c, apex) + steps.x * displacementOf(c, apex ^ 1) +
               steps.y * displacementOf(c, apex ^ 2) + steps.z * displacementOf(c, apex ^ 4);
    // The central tetrahedron has the other corners.
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        int corner = i == 0 ? 0 : 7 - (8 >> i);
        if (odd == 1u) corner ^= 7;
        vec3 s = mix(u, 1.0 - u, bvec3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0));
        sum += (1.0 - 0.5 * (s.x + s.y + s.z)) * displacementOf(c, corner);
    }
    return sum;
}

// Whether the bond through the vertex's face holds, or the body is not there: then nothing can see it.
bool hidden() {
    if (texelFetch(damage, damageStride * int(owner.x)).w == SUNDER_GONE) return true;
    uint code = owner.y;
    if ((code & SUNDER_DISPLAY_FACE_INNER) == 0u) return false;
    int axis = int(code >> uint(SUNDER_DISPLAY_FACE_BIT + 1) & 3u);
    return texelFetch(damage, damageStride * int(owner.z))[axis] < 1.0;
}

#ifndef DEPTH_ONLY
// How cell c's deformed face (2 * axis + side), a bilinear patch, goes on at u: along the next axis and the one after that.
mat2x3 patchAxes(int c, int face, vec3 u, Lattice lattice) {
    int axis = face >> 1, b = (axis + 1) % 3, e = (axis + 2) % 3;
    int base = (face & 1) << axis;
    vec3 d00 = displacementOf(c, base), d10 = displacementOf(c, base | 1 << b);
    vec3 d01 = displacementOf(c, base | 1 << e), d11 = displacementOf(c, base | 1 << b | 1 << e);
    vec3 alongB = mix(d10 - d00, d11 - d01, clamp(u[e], 0.0, 1.0));
    vec3 alongE = mix(d01 - d00, d11 - d10, clamp(u[b], 0.0, 1.0));
    vec3 edgeB = vec3(0.0), edgeE = vec3(0.0);
    edgeB[b] = lattice.cellSize[b];
    edgeE[e] = lattice.cellSize[e];
    return mat2x3(alongB + inWorld(lattice, edgeB), alongE + inWorld(lattice, edgeE));
}

// Outwards. Its length is a measure of area.
vec3 patchNormal(int c, int face, vec3 u, Lattice lattice) {
    mat2x3 along = patchAxes(c, face, u, lattice);
    vec3 n = cross(along[0], along[1]);
    return (face & 1) == 1 ? n : -n;
}

// Mean over the cells that share the vertex and lie in the same outside, so that a bent sheet looks bent and not faceted.
vec3 outsideNormal(int face, uint planes, uint own, uint group, int low, Lattice lattice) {
    uint across = 1u << uint(face >> 1);
    vec3 sum = vec3(0.0);
    for (uint octant = 0u; octant < 8u; ++octant) {
        if ((octant & ~planes) != 0u || (group >> octant & 1u) == 0u) continue;
        if ((planes & across) != 0u && octant != own) continue;  // beside a hole: others may go on behind the face
        ivec3 at = ivec3(octant & 1u, octant >> 1 & 1u, octant >> 2);
        int c = low + at.x * lattice.strides.x + at.y * lattice.strides.y + at.z * lattice.strides.z;
        vec3 u = alongAxes(lattice, start - texelFetch(rest, 8 * c).xyz) / lattice.cellSize;
        sum += patchNormal(c, face, u, lattice);
    }
    return sum;
}
#endif

#ifdef HOST_VERTEX
void displayedVertex() {
#else
void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside every view
#endif
    int self = int(owner.x);
    uint code = owner.y;
#ifndef DEPTH_ONLY
    paintedCell = self;
    position = normal = place = vec3(0.0);
    surfaceLaw = 0u;
    seed = insideFace = boundaryFace = 0.0;
#endif
    if (hidden()) {
#ifdef SURFACE
        // All corners of the face at one place.
        position = texelFetch(rest, 8 * self).xyz + displacementOf(self, 0);
        normal = vec3(0.0, 1.0, 0.0);
        tangent = vec4(1.0, 0.0, 0.0, 1.0);
#endif
        return;
    }

    uvec4 record = texelFetch(cells, self);
    Lattice lattice = latticeOf(int(record.g));
    uint planes = 0u, own = 0u;
    int low = self;
    for (int axis = 0; axis < 3; ++axis) {
        uint plane = code >> uint(SUNDER_DISPLAY_PLANES_BIT + 2 * axis) & 3u;
        if (plane != 0u) planes |= 1u << uint(axis);
        if (plane == 1u) {
            own |= 1u << uint(axis);
            low -= lattice.strides[axis];
        }
    }
    uint group = groupAround(planes, own, low, lattice.strides);

    // Bound to the cell that the vertex lies in, or else the next that hangs together with its own: the same for all of them.
    uint side = code >> uint(SUNDER_DISPLAY_SIDE_BIT) & planes;
    uint octant = own;
    for (uint turn = 8u; turn-- > 0u;)
        if ((turn & ~planes) == 0u && (group >> (side ^ turn) & 1u) != 0u) octant = side ^ turn;
    ivec3 at = ivec3(octant & 1u, octant >> 1 & 1u, octant >> 2);
    int bound = low + at.x * lattice.strides.x + at.y * lattice.strides.y + at.z * lattice.strides.z;

    // What has come apart draws back. High octants of an axis: 170 = 0b10101010, 204 and 240.
    const uvec3 HIGH = uvec3(170u, 204u, 240u);
    vec3 back = vec3(0.0);
    uvec3 high = uvec3(group) & HIGH;
    for (int axis = 0; axis < 3; ++axis) {
        bool outside = (code >> uint(SUNDER_DISPLAY_OUTSIDE_BIT + axis) & 1u) != 0u;
        if ((planes >> uint(axis) & 1u) == 0u || outside) continue;
        float gap = SUNDER_DISPLAY_GAP * lattice.cellSize[axis];
        if (high[axis] == 0u) back[axis] -= gap;
        if (high[axis] == group) back[axis] += gap;
    }
    vec3 p = start + inWorld(lattice, back);

    vec3 u = alongAxes(lattice, p - texelFetch(rest, 8 * bound).xyz) / lattice.cellSize;
    vec3 moved = p + displacementAt(bound, u);
#ifndef HOST_VERTEX
    gl_Position = viewProjection * vec4(moved, 1.0);
#endif
#ifndef DEPTH_ONLY
    position = moved;
    if ((code & SUNDER_DISPLAY_FACE_INNER) == 0u)
        normal = outsideNormal(int(code >> uint(SUNDER_DISPLAY_FACE_BIT) & 7u), planes, own, group, low, lattice);
    surfaceLaw = record.r & SUNDER_CELL_LAW;
    place = alongAxes(lattice, start - texelFetch(rest, 8 * lattice.firstCell).xyz);
    seed = fract(0.618034 * float(record.g));
    insideFace = (code & SUNDER_DISPLAY_FACE_INNER) != 0u ? 1.0 : 0.0;
    boundaryFace = (code & SUNDER_DISPLAY_FACE_BOUNDARY) != 0u ? 1.0 : 0.0;
#endif
#ifdef SURFACE
    int face = int(code >> uint(SUNDER_DISPLAY_FACE_BIT) & 7u);
    vec3 inCell = alongAxes(lattice, start - texelFetch(rest, 8 * self).xyz) / lattice.cellSize;
    if (normal == vec3(0.0)) normal = patchNormal(self, face, inCell, lattice);
    normal = normalize(normal);
    mat2x3 along = patchAxes(self, face, inCell, lattice);
    // Textures go along z and y, x and z, x and y.
    bool turned = face >> 1 == 2;
    vec3 first = turned ? along[0] : along[1], second = turned ? along[1] : along[0];
    first = normalize(first - dot(first, normal) * normal);
    tangent = vec4(first, dot(cross(normal, first), second) < 0.0 ? -1.0 : 1.0);
#endif
}
