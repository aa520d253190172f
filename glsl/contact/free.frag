// What spheres that may touch something would do without contact, one fragment per sphere: the force of constraint follows from it
// (src/core/contact.hpp).
#include "contact/sphere_texel.glsl"
#include "contact/storage.glsl"
#include "physics/links.glsl"

#if BUFFERS
uniform sampler2D forces;  // N, of elements; one texel per node

vec3 forceOn(int cell, int corner) { return texelFetch(forces, texelAddress(8 * cell + corner), 0).xyz; }
#else
uniform sampler2DArray forces;  // N, of elements; one layer per corner

vec3 forceOn(int cell, int corner) { return texelFetch(forces, ivec3(texelAddress(cell), corner), 0).xyz; }
#endif
uniform sampler2DArray partners;   // contact/search.frag
uniform sampler2DArray summaries;  // of that, layer 0, per cell

layout(location = 0) out vec4 free;  // acceleration, m/s²; w: what a newton on each cell that may touch something does, 1/kg

void main() {
    if (texelFetch(partners, ivec3(gl_FragCoord.xy, 0), 0).x == 0.0) discard;
    int sphere = fragmentSphere(), cell = cellOf(sphere);
    BodyRecord body = bodyRecord(bodyOf(cellRecord(cell)));
    vec3 place = placeInCell(sphere, sphereCounts(body));
    ivec3 strides = cellStrides(ivec4(body.lattice));
    vec4 masks = linkMasksOf(cell);
    free = vec4(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        float inverseMass = inverseMassesOf(cell, corner >> 2)[corner & 3];
        if (inverseMass == 0.0) continue;
        uint mask = linkMaskOf(masks, corner);
        vec3 force = vec3(0.0);
        float listed = 0.0;
        for (int octant = 0; octant < 8; ++octant) {
            if ((mask >> uint(octant) & 1u) == 0u) continue;
            ivec3 steps = (cornerBits(octant) - cornerBits(corner ^ 7)) * strides;
            int other = cell + steps.x + steps.y + steps.z;
            force += forceOn(other, octant ^ 7);
            if (texelFetch(summaries, ivec3(texelAddress(other), 0), 0).x > 0.0) listed += 1.0;
        }
        free += cornerWeight(place, corner) * vec4(force * inverseMass + body.gravity.xyz, 0.125 * listed * inverseMass);
    }
}
