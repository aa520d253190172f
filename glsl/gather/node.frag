// Node update: one fragment per node. Gathers the forces of the joined copies and writes the new state into two float targets.
#include "gather/cell_texel.glsl"
#include "physics/lattice.glsl"
#include "physics/links.glsl"
#include "physics/events.glsl"
#include "physics/integrate.glsl"

uniform sampler2DArray nodes;   // layer 0: xyz displacement, m; w: rest height, m, carried along for the ground; layer 1: velocity, largest speed
uniform sampler2DArray forces;  // per cell, one layer per corner: N, on one copy
uniform sampler2DArray links;   // layers of LinkRecord
#if EVENTS
uniform samplerBuffer rest;  // xyz: rest position, m
uniform float stepInFrame;
#endif

uniform bool newWatch;  // this is the first step since bodies were last looked at for rest

layout(location = 0) out vec4 newDisplacement;
layout(location = 1) out vec4 newVelocity;  // w: largest squared speed since then, m²/s²

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    newDisplacement = texelFetch(nodes, ivec3(texel, 0), 0);
    newVelocity = vec4(0.0);
    int node = fragmentIndex(), cell = node >> 3, corner = node & 7;
    ivec2 cellTexel = texelAddress(cell);
    float inverseMass = texelFetch(links, ivec3(cellTexel, corner < 4 ? 1 : 2), 0)[corner & 3];
    if (inverseMass == 0.0) return;  // anchored, or no cell here
    uint mask = linkMaskOf(texelFetch(links, ivec3(cellTexel, 0), 0), corner);

    BodyRecord body = bodyRecord(bodyOf(cellRecord(cell)));
    ivec3 strides = cellStrides(ivec4(body.lattice));
    // The cell in octant 0 of this node's lattice point, whose corner 7 it is.
    ivec3 back = -cornerBits(corner ^ 7) * strides;
    int base = cell + back.x + back.y + back.z;
    vec3 force = vec3(0.0);
    // The same order for every copy of the lattice point, so that all of them stay equal to the bit.
    for (int octant = 0; octant < 8; ++octant) {
        if ((mask >> uint(octant) & 1u) == 0u) continue;
        ivec3 steps = cornerBits(octant) * strides;
        force += texelFetch(forces, ivec3(texelAddress(base + steps.x + steps.y + steps.z), octant ^ 7), 0).xyz;
    }
    vec3 acceleration = force * inverseMass + body.gravity.xyz;
#if EVENTS
    acceleration += eventAcceleration(body.events.xy, texelFetch(rest, node).xyz, stepInFrame);
#endif
    vec4 old = texelFetch(nodes, ivec3(texel, 1), 0);
    vec3 u = newDisplacement.xyz, v = old.xyz;
    integrateNode(u, v, acceleration, body.gravity.w, body.cellSize.w, newDisplacement.w);
    newDisplacement.xyz = u;
    newVelocity = vec4(v, newWatch ? dot(v, v) : max(dot(v, v), old.w));
}
