// Contact search: one fragment per sphere. Whether it may touch anything.
//
// It cannot where all around it belongs to one body, nothing there is loose, and no displacement differs from another by a radius:
// joined neighbours never push, and the spheres of cells two or more apart are a diameter from each other at rest, half of which they
// would have to come closer before they get on a list.
#include "contact/region.glsl"
#include "contact/sphere_texel.glsl"

uniform sampler2DArray regions;

layout(location = 0) out vec4 exposed;  // x: 1; what is not drawn stays 0

void main() {
    vec4 centre = texelFetch(spheres, ivec3(gl_FragCoord.xy, 0), 0);
    if (centre.w == 0.0) discard;
    ivec3 low = regionOf(centre.xyz - 0.5 * regionSize);
    vec4 first = vec4(kNothing), second = vec4(kNothing);
    for (int i = 0; i < 8; ++i) {
        ivec2 texel = regionTexel(low + cornerBits(i));
        first = max(first, texelFetch(regions, ivec3(texel, 0), 0));
        second = max(second, texelFetch(regions, ivec3(texel, 1), 0));
    }
    bool alone = first.x == -first.y && first.x < kLoose;
    vec3 spread = vec3(first.z + first.w, second.x + second.y, second.z + second.w);
    if (alone && dot(spread, spread) < centre.w * centre.w) discard;
    exposed = vec4(1.0);
}
