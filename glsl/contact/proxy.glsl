// The spheres that stand for a cell (ContactProxy in src/core/contact.hpp), and how its corners share what happens at a place in it.
#include "physics/lattice.glsl"

// Spheres of a cell along x, y and z.
vec3 sphereCounts(BodyRecord body) {
    int counts = int(body.spheres.x);
    return vec3(counts & 15, counts >> 4 & 15, counts >> 8);
}

// Trilinear weight of a corner at a place in its cell, each coordinate 0 to 1.
float cornerWeight(vec3 place, int corner) {
    vec3 along = mix(1.0 - place, place, notEqual(cornerBits(corner), ivec3(0)));
    return along.x * along.y * along.z;
}
