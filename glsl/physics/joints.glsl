// Which nodes of a cell are joined to which, and the masses of their groups. Where damage lies is the solver's affair: the file
// that includes this defines damageOf().
#include "physics/lattice.glsl"
#include "physics/links.glsl"

uniform samplerBuffer rest;  // w: mass of this copy, kg, negative where anchored

vec3 damageOf(int cell);  // of the bonds through its +x, +y, +z faces

LinkRecord joints(int cell) {
    uint record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return LinkRecord(vec4(0.0), vec4(0.0), vec4(0.0));
    ivec4 lattice = ivec4(bodyRecord(bodyOf(record)).lattice);
    ivec3 strides = cellStrides(lattice), here = cellCoordinates(cell, lattice);

    // Bits 0, 1, 2: the bonds that the 27 cells around this one own through their +x, +y, +z faces and that hold.
    uint held[27];
    for (int i = 0; i < 27; ++i) {
        ivec3 offset = ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        ivec3 c = here + offset;
        held[i] = 0u;
        if (any(lessThan(c, ivec3(0))) || any(greaterThanEqual(c, lattice.xyz))) continue;
        ivec3 steps = offset * strides;
        vec3 damage = damageOf(cell + steps.x + steps.y + steps.z);
        held[i] = uint(damage.x < 1.0) | uint(damage.y < 1.0) << 1u | uint(damage.z < 1.0) << 2u;
    }
    uint masks[8];
    float inverseMass[8];
    for (int corner = 0; corner < 8; ++corner) {
        int own = corner ^ 7;
        uvec3 around = uvec3(0u);
        for (int octant = 0; octant < 8; ++octant) {
            ivec3 offset = cornerBits(octant) - cornerBits(own) + 1;
            uint owned = held[offset.x + 3 * offset.y + 9 * offset.z];
            for (int axis = 0; axis < 3; ++axis)
                if ((octant >> axis & 1) == 0) around[axis] |= (owned >> uint(axis) & 1u) << uint(octant);
        }
        uint mask = linkMask(around, own);
        masks[corner] = mask;

        // The same order for every copy of the lattice point, as for forces.
        float mass = 0.0;
        bool anchored = false;
        for (int octant = 0; octant < 8; ++octant) {
            if ((mask >> uint(octant) & 1u) == 0u) continue;
            ivec3 steps = (cornerBits(octant) - cornerBits(own)) * strides;
            float own_ = texelFetch(rest, 8 * (cell + steps.x + steps.y + steps.z) + (octant ^ 7)).w;
            mass += abs(own_);
            if (own_ < 0.0) anchored = true;
        }
        inverseMass[corner] = anchored ? 0.0 : 1.0 / mass;
    }
    return LinkRecord(vec4(masks[0] + 256u * masks[1], masks[2] + 256u * masks[3], masks[4] + 256u * masks[5],
                           masks[6] + 256u * masks[7]),
                      vec4(inverseMass[0], inverseMass[1], inverseMass[2], inverseMass[3]),
                      vec4(inverseMass[4], inverseMass[5], inverseMass[6], inverseMass[7]));
}
