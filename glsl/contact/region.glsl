// Regions: voxels twice as wide as spheres can be apart and still get on a list. What lies in each, in two layers blended by MAX:
//   0  body, −body, u_x, −u_x      u: displacement of a sphere, m
//   1  u_y, −u_y, u_z, −u_z
// and kNothing where nothing does. A sphere whose cell is not joined to all its neighbours stands for a body of its own: kLoose.
#include "physics/lattice.glsl"

uniform ivec3 regionStrides;  // texels from one region to the next along x, y, z
uniform ivec2 regionBits;     // columns and rows are these powers of two
uniform float regionSize;     // m
const float kNothing = -1.0e30, kLoose = 3.0e7;

ivec3 regionOf(vec3 position) { return ivec3(floor(clamp(position / regionSize, -1.0e6, 1.0e6))); }

// Regions that share a texel are taken for one.
ivec2 regionTexel(ivec3 region) {
    uvec3 steps = uvec3(region) * uvec3(regionStrides);
    uint number = steps.x + steps.y + steps.z;
    return ivec2(number & ((1u << uint(regionBits.x)) - 1u), number >> uint(regionBits.x) & ((1u << uint(regionBits.y)) - 1u));
}
