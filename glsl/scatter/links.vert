// Link masks after bonds broke: one vertex per cell, eight masks of eight bits, written by transform feedback.
#include "physics/lattice.glsl"
#include "physics/links.glsl"

uniform samplerBuffer bonds;  // BondRecord

flat out uvec2 newLinks;

void main() {
    uvec2 packed_ = uvec2(0u);
    newLinks = packed_;
    uint record = cellRecord(gl_VertexID);
    if (lawOf(record) == SUNDER_ABSENT) return;
    ivec4 lattice = ivec4(bodyRecord(bodyOf(record)).lattice);
    ivec3 strides = cellStrides(lattice), here = cellCoordinates(gl_VertexID, lattice);

    // Bits 0, 1, 2: the bonds that the 27 cells around this one own through their +x, +y, +z faces and that hold.
    uint held[27];
    for (int i = 0; i < 27; ++i) {
        ivec3 offset = ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        ivec3 c = here + offset;
        held[i] = 0u;
        if (any(lessThan(c, ivec3(0))) || any(greaterThanEqual(c, lattice.xyz))) continue;
        ivec3 steps = offset * strides;
        vec3 damage = texelFetch(bonds, 2 * (gl_VertexID + steps.x + steps.y + steps.z)).xyz;
        held[i] = uint(damage.x < 1.0) | uint(damage.y < 1.0) << 1u | uint(damage.z < 1.0) << 2u;
    }
    for (int corner = 0; corner < 8; ++corner) {
        int own = corner ^ 7;
        uvec3 around = uvec3(0u);
        for (int octant = 0; octant < 8; ++octant) {
            ivec3 offset = cornerBits(octant) - cornerBits(own) + 1;
            uint owned = held[offset.x + 3 * offset.y + 9 * offset.z];
            for (int axis = 0; axis < 3; ++axis)
                if ((octant >> axis & 1) == 0) around[axis] |= (owned >> uint(axis) & 1u) << uint(octant);
        }
        uint mask = linkMask(around, own) << uint(8 * (corner & 3));
        if (corner < 4) packed_.x |= mask;
        else packed_.y |= mask;
    }
    newLinks = packed_;
}
