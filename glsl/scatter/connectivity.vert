// Connectivity update (thesis, figure 7.4): one point per node. Adds up the forces of the nodes it is joined to.
#include "physics/lattice.glsl"
#include "physics/links.glsl"
#include "scatter/textures.glsl"

uniform sampler2D forces;      // rgb: N; a: inverse mass of this copy, 0 where anchored
uniform samplerBuffer links;  // LinkRecord
uniform float targetHeight;

out vec4 cumulative;  // rgb: N, of the joined group; a: its inverse mass, 0 where anchored

void main() {
    int cell = gl_VertexID >> 3, corner = gl_VertexID & 7, own = corner ^ 7;
    gl_Position = texelPosition(gl_VertexID, targetHeight);
    cumulative = vec4(0.0);
    uvec4 record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return;
    ivec3 strides = cellStrides(ivec4(bodyRecord(bodyOf(record)).lattice));
    uint mask = linkMaskOf(texelFetch(links, SUNDER_LINK_TEXELS * cell), corner);

    vec3 force = vec3(0.0);
    float mass = 0.0;
    bool anchored = false;
    // The same order for every copy of the lattice point, so that all of them stay equal to the bit.
    for (int octant = 0; octant < 8; ++octant) {
        if ((mask >> uint(octant) & 1u) == 0u) continue;
        ivec3 offset = cornerBits(octant) - cornerBits(own);
        ivec3 steps = offset * strides;
        int member = 8 * (cell + steps.x + steps.y + steps.z) + (octant ^ 7);
        vec4 texel = texelFetch(forces, texelAddress(member), 0);
        force += texel.rgb;
        if (texel.a == 0.0) anchored = true;
        else mass += 1.0 / texel.a;
    }
    cumulative = vec4(force, anchored ? 0.0 : 1.0 / mass);
}
