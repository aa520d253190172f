// Where spheres are and how they move, one fragment per sphere. LISTED: only those with partners, which are all that matter between
// two searches.
#include "contact/sphere_texel.glsl"
#include "contact/storage.glsl"

uniform samplerBuffer rest;       // xyz: rest position of a node, m
#if LISTED
uniform sampler2DArray partners;  // contact/search.frag
#endif

layout(location = 0) out vec4 centre;    // m; w: radius, m, 0 where there is no sphere
layout(location = 1) out vec4 velocity;  // m/s; w unused

void main() {
#if LISTED
    if (texelFetch(partners, ivec3(gl_FragCoord.xy, 0), 0).x == 0.0) discard;
#endif
    centre = velocity = vec4(0.0);
    int sphere = fragmentSphere(), cell = cellOf(sphere);
    uvec4 record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return;
    BodyRecord body = bodyRecord(bodyOf(record));
    vec3 place = placeInCell(sphere, sphereCounts(body));
    if (place.z > 1.0) return;
    vec3 x = texelFetch(rest, 8 * cell).xyz + alongAxes(body, place * body.cellSize.xyz), v = vec3(0.0);
    for (int k = 0; k < 8; ++k) {
        float weight = cornerWeight(place, k);
        x += weight * displacementOf(cell, k);
        v += weight * velocityOf(cell, k);
    }
    centre = vec4(x, body.spheres.y);
    velocity = vec4(v, 0.0);
}
