// What the spheres of a cell hand on to its corners.
#include "contact/sphere.glsl"

uniform sampler2DArray sphereForces;  // contact/push.frag
uniform sampler2DArray partners;      // contact/search.frag
uniform sampler2DArray summaries;     // of that, layer 0, per cell

bool touches(int cell) { return texelFetch(summaries, ivec3(texelAddress(cell), 0), 0).x > 0.0; }

// N, on each corner.
void cornerForces(int cell, out vec3 forces[8]) {
    for (int k = 0; k < 8; ++k) forces[k] = vec3(0.0);
    vec3 counts = sphereCounts(bodyRecord(bodyOf(cellRecord(cell))));
    for (int i = 0; i < 1 << SPHERE_BITS; ++i) {
        int sphere = cell << SPHERE_BITS | i;
        ivec3 texel = ivec3(sphereAddress(sphere), 0);
        if (texelFetch(partners, texel, 0).x > 0.0) {
            vec3 force = texelFetch(sphereForces, texel, 0).xyz, place = placeInCell(sphere, counts);
            for (int k = 0; k < 8; ++k) forces[k] += cornerWeight(place, k) * force;
        }
    }
}
