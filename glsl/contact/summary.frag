// Contact search where cells have several spheres: what they found, one fragment per cell (contact/search.frag).
#include "gather/cell_texel.glsl"
#include "contact/sphere.glsl"
#include "contact/left_out.glsl"

uniform sampler2DArray partners;

layout(location = 0) out vec4 summary;

void main() {
    summary = vec4(0.0);
    int first = fragmentIndex() << SPHERE_BITS;
    for (int i = 0; i < 1 << SPHERE_BITS; ++i) {
        vec4 some = texelFetch(partners, ivec3(sphereAddress(first + i), 0), 0);
        float haste = max(hasteOf(summary.z), hasteOf(some.z));
        summary = vec4(summary.xy + some.xy, leftOut(droppedOf(summary.z) + droppedOf(some.z), haste), max(summary.w, some.w));
    }
}
