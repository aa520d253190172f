// Contact search: one point per sphere, into its region's texel.
#include "contact/joined.glsl"
#include "contact/region.glsl"
#include "contact/sphere.glsl"
#include "contact/storage.glsl"

uniform samplerBuffer rest;  // xyz: rest position of a node, m

flat out float body;
flat out vec3 displacement;

void main() {
    gl_PointSize = 1.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    body = 0.0;
    displacement = vec3(0.0);
    vec4 centre = texelFetch(spheres, ivec3(sphereAddress(gl_VertexID), 0), 0);
    if (centre.w == 0.0) return;
    int cell = cellOf(gl_VertexID);
    uvec4 record = cellRecord(cell);
    BodyRecord own = bodyRecord(bodyOf(record));
    body = whole(linkMasksOf(cell), record.x) ? float(record.y) : kLoose;
    displacement = centre.xyz - texelFetch(rest, 8 * cell).xyz -
                   alongAxes(own, placeInCell(gl_VertexID, sphereCounts(own)) * own.cellSize.xyz);
    vec2 texel = (vec2(regionTexel(regionOf(centre.xyz))) + 0.5) / vec2(1 << regionBits.x, 1 << regionBits.y);
    gl_Position = vec4(2.0 * texel - 1.0, 0.0, 1.0);
}
