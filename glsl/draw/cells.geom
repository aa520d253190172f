// Makes a visible face of a cell from the node buffer (thesis, figure 6.6): two triangles, split along the diagonal that the
// cell's tetrahedra have there, so that the twelve triangles of a hull hold every edge of its tetrahedra.
#include "draw/clusters.glsl"
#include "draw/looks.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

uniform samplerBuffer bodies;
uniform samplerBuffer displacements;
uniform ivec2 displacementStrides;  // texels from one cell's to the next, from one corner's to the next
uniform samplerBuffer rest;
uniform mat4 viewProjection;

flat in int cell[];
flat in int face[];
flat in uint law[];
flat in ivec4 lattice[];
flat in uint parity_[];
flat in uint inside[];
flat in uint crackedEdges[];

#ifndef DEPTH_ONLY
out vec3 position;             // m, world
out vec3 place;                // m, at rest, from the body's low corner
out vec2 facePosition;         // 0 to 1 along the face's two sides
flat out vec3 normal;
flat out uint surfaceLaw;
#ifdef LINES
flat out vec3 baseColour;      // linear RGB
#endif
flat out float seed;           // 0 to 1, of the body
flat out int paintedCell;      // for draw/paint.glsl
flat out float insideFace;     // 1 on a face that a broken bond has bared
flat out float boundaryFace;   // 1 where that bond held two bricks or planks together
flat out uint cracks;          // bits 0 to 3: a crack runs along facePosition x = 0, x = 1, y = 0, y = 1
flat out float diagonalSlope;  // +1: the diagonal is x = y; -1: it is x + y = 1
#endif

vec3 cornerPosition(int corner) {
    int texel = displacementStrides.x * cell[0] + displacementStrides.y * corner;
    return texelFetch(rest, 8 * cell[0] + corner).xyz + texelFetch(displacements, texel).xyz;
}

#ifndef DEPTH_ONLY
bool onBoundary(vec3 cellSize) {
    if (inside[0] == 0u) return false;
    vec3 centre = (vec3(lattice[0].xyz) + 0.5) * cellSize, beyond = centre;
    beyond[face[0] >> 1] += (face[0] & 1) == 1 ? cellSize[face[0] >> 1] : -cellSize[face[0] >> 1];
    return clustersPart(looks[law[0]], centre, beyond);
}
#endif

// EmitVertex leaves all outputs undefined, so every vertex sets every one.
void emit(int corner, vec3 p, vec3 faceNormal, vec2 onFace, bool rising) {
    gl_Position = viewProjection * vec4(p, 1.0);
#ifndef DEPTH_ONLY
    vec3 cellSize = texelFetch(bodies, SUNDER_BODY_TEXELS * lattice[0].w + 1).xyz;
    position = p;
    place = cellSize * vec3(lattice[0].xyz + (ivec3(corner) >> ivec3(0, 1, 2) & 1));
    facePosition = onFace;
    normal = faceNormal;
    surfaceLaw = law[0];
#ifdef LINES
    baseColour = looks[law[0]].outside.rgb;
#endif
    seed = fract(0.618034 * float(lattice[0].w));
    paintedCell = cell[0];
    insideFace = float(inside[0]);
    boundaryFace = onBoundary(cellSize) ? 1.0 : 0.0;
    cracks = crackedEdges[0];
    diagonalSlope = rising ? 1.0 : -1.0;
#endif
    EmitVertex();
}

void main() {
    if (face[0] < 0) return;
    int axis = face[0] >> 1, side = face[0] & 1;
    int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3);
    int base = side << axis;
    // The central tetrahedron's corners have as many bits set as the cell's parity, modulo 2; the diagonal joins two of them.
    bool rising = uint(side) == parity_[0];

    // A strip is split between its second and third vertex; exchanging those two turns the face round.
    ivec4 corners = rising ? ivec4(u, u | v, 0, v) : ivec4(0, u, v, u | v);
    vec4 x = rising ? vec4(1, 1, 0, 0) : vec4(0, 1, 0, 1);
    vec4 y = rising ? vec4(0, 1, 0, 1) : vec4(0, 0, 1, 1);
    if (side == 0) {
        corners = corners.xzyw;
        x = x.xzyw;
        y = y.xzyw;
    }
    vec3 a = cornerPosition(base | corners.x), b = cornerPosition(base | corners.y);
    vec3 c = cornerPosition(base | corners.z), d = cornerPosition(base | corners.w);
    // A triangle takes its flat values from its last vertex.
    vec3 first = cross(b - a, c - a), second = cross(b - c, d - c);

    emit(base | corners.x, a, first, vec2(x.x, y.x), rising);
    emit(base | corners.y, b, first, vec2(x.y, y.y), rising);
    emit(base | corners.z, c, first, vec2(x.z, y.z), rising);
    emit(base | corners.w, d, second, vec2(x.w, y.w), rising);
    EndPrimitive();
}
