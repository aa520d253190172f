// Contact forces on the corners of cells with several spheres, one fragment per cell that touches something.
#include "gather/cell_texel.glsl"
#include "contact/sphere.glsl"

uniform sampler2DArray sphereForces;  // contact/push.frag
uniform sampler2DArray partners;      // contact/search.frag
uniform sampler2DArray summaries;     // of that, layer 0, per cell

layout(location = 0) out vec4 forces[8];  // N, blended by addition

void main() {
    if (texelFetch(summaries, ivec3(gl_FragCoord.xy, 0), 0).x == 0.0) discard;
    int cell = fragmentIndex();
    vec3 counts = sphereCounts(bodyRecord(bodyOf(cellRecord(cell))));
    vec3 sum[8];
    for (int k = 0; k < 8; ++k) sum[k] = vec3(0.0);
    for (int i = 0; i < 1 << SPHERE_BITS; ++i) {
        int sphere = cell << SPHERE_BITS | i;
        ivec3 texel = ivec3(sphereAddress(sphere), 0);
        if (texelFetch(partners, texel, 0).x > 0.0) {
            vec3 force = texelFetch(sphereForces, texel, 0).xyz, place = placeInCell(sphere, counts);
            for (int k = 0; k < 8; ++k) sum[k] += cornerWeight(place, k) * force;
        }
    }
    for (int k = 0; k < 8; ++k) forces[k] = vec4(sum[k], 0.0);
}
