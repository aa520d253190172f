// Node update: again one vertex per cell. Gathers for each of its eight nodes the forces of the joined copies and writes eight new
// node states (64 components, the most that transform feedback guarantees).
#include "physics/lattice.glsl"
#include "physics/links.glsl"
#include "physics/events.glsl"
#include "physics/integrate.glsl"

uniform samplerBuffer nodes;   // NodeRecord
uniform samplerBuffer forces;  // per node: N, on one copy
#if EVENTS
uniform samplerBuffer rest;  // xyz: rest position, m
#endif
uniform usamplerBuffer links;  // LinkRecord
uniform float stepInFrame;

out vec4 newNodes[16];  // displacement, velocity of corner 0, of corner 1, …

void main() {
    uint record = cellRecord(gl_VertexID);
    BodyRecord body = bodyRecord(bodyOf(record));
    ivec3 strides = cellStrides(ivec4(body.lattice));
    uvec4 masks = texelFetch(links, SUNDER_LINK_TEXELS * gl_VertexID);
    vec4 low = uintBitsToFloat(texelFetch(links, SUNDER_LINK_TEXELS * gl_VertexID + 1));
    vec4 high = uintBitsToFloat(texelFetch(links, SUNDER_LINK_TEXELS * gl_VertexID + 2));

    for (int corner = 0; corner < 8; ++corner) {
        int node = 8 * gl_VertexID + corner;
        vec4 displacement = texelFetch(nodes, 2 * node);
        float inverseMass = corner < 4 ? low[corner & 3] : high[corner & 3];
        newNodes[2 * corner] = displacement;
        newNodes[2 * corner + 1] = vec4(0.0);
        if (inverseMass == 0.0) continue;  // anchored, or no cell here

        uint mask = linkMaskOf(masks, corner);
        // The cell in octant 0 of this corner's lattice point, whose corner 7 it is.
        ivec3 back = -cornerBits(corner ^ 7) * strides;
        int base = gl_VertexID + back.x + back.y + back.z;
        vec3 force = vec3(0.0);
        // The same order for every copy of the lattice point, so that all of them stay equal to the bit.
        for (int octant = 0; octant < 8; ++octant) {
            if ((mask >> uint(octant) & 1u) == 0u) continue;
            ivec3 steps = cornerBits(octant) * strides;
            force += texelFetch(forces, 8 * (base + steps.x + steps.y + steps.z) + (octant ^ 7)).xyz;
        }
        vec3 acceleration = force * inverseMass + body.gravity.xyz;
#if EVENTS
        acceleration += eventAcceleration(body.events.xy, texelFetch(rest, node).xyz, stepInFrame);
#endif
        vec3 u = displacement.xyz, v = texelFetch(nodes, 2 * node + 1).xyz;
        integrateNode(u, v, acceleration, body.gravity.w, body.cellSize.w, displacement.w);
        newNodes[2 * corner] = vec4(u, displacement.w);
        newNodes[2 * corner + 1] = vec4(v, 0.0);
    }
}
