// Contact forces on the corners of cells with several spheres, one fragment per cell that touches something.
#include "gather/cell_texel.glsl"
#include "contact/corner_forces.glsl"

layout(location = 0) out vec4 forces[8];  // N, blended by addition

void main() {
    int cell = fragmentIndex();
    if (!touches(cell)) discard;
    vec3 sum[8];
    cornerForces(cell, sum);
    for (int k = 0; k < 8; ++k) forces[k] = vec4(sum[k], 0.0);
}
