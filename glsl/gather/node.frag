// Node update: one fragment per cell and four of its corners (FIRST and the next three), or one invocation per cell and corner.
// Gathers for each the forces of the joined copies and writes its new state into two float targets.
#include "gather/cell_texel.glsl"
#include "gather/node.glsl"
#include "physics/lattice.glsl"
#include "physics/links.glsl"
#include "physics/events.glsl"
#include "physics/integrate.glsl"

uniform sampler2DArray forces;  // per cell, one layer per corner: N, on one copy
uniform sampler2DArray links;   // layers of LinkRecord
#if EVENTS || ROOM
uniform samplerBuffer rest;  // xyz: rest position, m
#endif
#if EVENTS
uniform float stepInFrame;
#endif
uniform bool newWatch;  // this is the first step since bodies were last looked at for rest

#ifndef COMPUTE
layout(location = 0) out vec4 newNodes[8];  // layers 2·FIRST to 2·FIRST + 7
#endif

// Force on the joined group of a corner's node. The same order for every copy of the lattice point, so that all of them stay equal
// to the bit.
vec3 groupForce(int cell, int corner, uint mask, ivec3 strides) {
    // The cell in octant 0 of this node's lattice point, whose corner 7 it is.
    ivec3 back = cornerBits(corner ^ 7) * strides;
    int base = cell - back.x - back.y - back.z;
    vec3 force = vec3(0.0);
    for (int octant = 0; octant < 8; ++octant) {
        if ((mask >> uint(octant) & 1u) != 0u) {
            ivec3 steps = cornerBits(octant) * strides;
            force += texelFetch(forces, ivec3(texelAddress(base + steps.x + steps.y + steps.z), octant ^ 7), 0).xyz;
        }
    }
    return force;
}

// In fragments, corner is a constant wherever this is called, so that the compiler indexes nothing at run time.
void updateNode(int corner, int cell, ivec2 texel, int bodyIndex, BodyRecord body, vec4 masks, float inverseMass,
                out vec4 displacement, out vec4 velocity) {
    displacement = texelFetch(nodes, ivec3(texel, displacementLayer(corner)), 0);
    velocity = texelFetch(nodes, ivec3(texel, velocityLayer(corner)), 0);
    vec3 force = groupForce(cell, corner, linkMaskOf(masks, corner), cellStrides(ivec4(body.lattice)));
#if EVENTS || ROOM
    vec3 restPosition = texelFetch(rest, 8 * cell + corner).xyz;
#else
    vec3 restPosition = vec3(0.0, displacement.w, 0.0);
#endif
    vec3 u = displacement.xyz, v = velocity.xyz;
#if EVENTS
    moveNode(force, inverseMass, body, eventAcceleration(bodyIndex, restPosition, u, stepInFrame), restPosition, u, v);
#else
    moveNode(force, inverseMass, body, vec3(0.0), restPosition, u, v);
#endif
    bool moves = inverseMass > 0.0;  // not anchored, and there is a cell
    displacement.xyz = moves ? u : displacement.xyz;
    velocity = moves ? vec4(v, newWatch ? dot(v, v) : max(dot(v, v), velocity.w)) : vec4(0.0);
}

#ifdef COMPUTE
void main() {
    int cell = invocationCell();
    if (cell < 0) return;
    ivec2 texel = texelAddress(cell);
    int corner = int(gl_WorkGroupID.y);
    vec4 masks = texelFetch(links, ivec3(texel, 0), 0);
    vec4 inverseMasses = texelFetch(links, ivec3(texel, 1 + corner / 4), 0);
    int index = bodyOf(cellRecord(cell));
    vec4 displacement, velocity;
    updateNode(corner, cell, texel, index, bodyRecord(index), masks, inverseMasses[corner & 3], displacement, velocity);
    imageStore(target, ivec3(texel, displacementLayer(corner)), displacement);
    imageStore(target, ivec3(texel, velocityLayer(corner)), velocity);
}
#else
void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int cell = fragmentIndex();
    vec4 masks = texelFetch(links, ivec3(texel, 0), 0);
    vec4 inverseMasses = texelFetch(links, ivec3(texel, 1 + FIRST / 4), 0);
    int index = bodyOf(cellRecord(cell));
    BodyRecord body = bodyRecord(index);
    updateNode(FIRST, cell, texel, index, body, masks, inverseMasses.x, newNodes[0], newNodes[1]);
    updateNode(FIRST + 1, cell, texel, index, body, masks, inverseMasses.y, newNodes[2], newNodes[3]);
    updateNode(FIRST + 2, cell, texel, index, body, masks, inverseMasses.z, newNodes[4], newNodes[5]);
    updateNode(FIRST + 3, cell, texel, index, body, masks, inverseMasses.w, newNodes[6], newNodes[7]);
}
#endif
