// Spheres of cells (src/core/contact.hpp). Number s of cell c is sphere c << SPHERE_BITS | s, for as many to a cell as any has in this
// world; what a body's cells have less of has radius 0.
#include "contact/proxy.glsl"

uniform sampler2DArray spheres;  // layer 0: centre, m; w: radius, m. Layer 1: velocity, m/s

int cellOf(int sphere) { return sphere >> SPHERE_BITS; }

ivec2 sphereAddress(int sphere) {
    int shift = textureShift + SPHERE_BITS;
    return ivec2(sphere & ((1 << shift) - 1), sphere >> shift);
}

// Where in its cell a sphere lies, each coordinate 0 to 1, and beyond 1 where the cell has not so many.
vec3 placeInCell(int sphere, vec3 counts) {
    float number = float(sphere & ((1 << SPHERE_BITS) - 1));
    float row = floor((number + 0.5) / counts.x), layer = floor((row + 0.5) / counts.y);
    return (vec3(number - row * counts.x, row - layer * counts.y, layer) + 0.5) / counts;
}
