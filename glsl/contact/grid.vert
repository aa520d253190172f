// Contact search: one point per exposed sphere, into its voxel's texel.
#include "contact/sphere.glsl"
#include "contact/grid.glsl"

uniform sampler2DArray exposed;  // contact/exposed.frag

flat out int number;
flat out int eighths;

void main() {
    number = gl_VertexID + 1;
    ivec2 address = sphereAddress(gl_VertexID);
    gl_PointSize = 1.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    eighths = 0;
    if (texelFetch(exposed, ivec3(address, 0), 0).x == 0.0) return;
    vec3 centre = texelFetch(spheres, ivec3(address, 0), 0).xyz;
    uint hash = voxelHash(voxelOf(centre));
    eighths = eighthsOf(centre, hash);
    vec2 texel = (vec2(voxelTexel(hash)) + 0.5) / vec2(1 << gridBits.x, 1 << gridBits.y);
    gl_Position = vec4(2.0 * texel - 1.0, 0.0, 1.0);
}
