// Contact search, second pass: one point per cell, into its voxel's texel.
#include "physics/lattice.glsl"
#include "contact/grid.glsl"

uniform sampler2DArray centres;

flat out int number;
flat out int eighth;

void main() {
    int cell = gl_VertexID;
    number = cell + 1;
    vec4 centre = texelFetch(centres, ivec3(texelAddress(cell), 0), 0);
    eighth = eighthOf(centre.xyz);
    vec2 texel = (vec2(voxelTexel(voxelOf(centre.xyz))) + 0.5) / vec2(1 << gridBits.x, 1 << gridBits.y);
    gl_Position = centre.w > 0.0 ? vec4(2.0 * texel - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = 1.0;
}
