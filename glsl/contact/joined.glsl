// Which cells around a cell it is joined to. The cell (x, y, z) steps away on the lattice is bit (x + 1) + 3 (y + 1) + 9 (z + 1).
#include "physics/lattice.glsl"
#include "physics/links.glsl"
#include "physics/octants.glsl"

// Whether all corners of a cell hang together with all that the body has room for around them. sides: SUNDER_CELL_SIDES_BIT.
bool whole(vec4 masks, uint record) {
    uint sides = record >> uint(SUNDER_CELL_SIDES_BIT);
    bool result = true;
    for (int corner = 0; corner < 8; ++corner) result = result && linkMaskOf(masks, corner) == octantsWithin(corner, sides);
    return result;
}

// Cells around that the body has room for.
uint latticeNeighbours(uint record) {
    uint sides = record >> uint(SUNDER_CELL_SIDES_BIT);
    uint around = 0x7FFFFFFu;
    around &= (sides & 1u) != 0u ? ~0x1249249u : around;
    around &= (sides & 2u) != 0u ? ~0x01C0E07u : around;
    around &= (sides & 4u) != 0u ? ~0x00001FFu : around;
    around &= (sides & 8u) != 0u ? ~0x4924924u : around;
    around &= (sides & 16u) != 0u ? ~0x70381C0u : around;
    around &= (sides & 32u) != 0u ? ~0x7FC0000u : around;
    return around;
}

// Cells around that share a joined node with it.
uint joinedNeighbours(vec4 masks) {
    uint result = 0u;
    for (int corner = 0; corner < 8; ++corner) {
        uint mask = linkMaskOf(masks, corner);
        uint spread = (mask & 3u) | (mask & 12u) << 1u | (mask & 48u) << 5u | (mask & 192u) << 6u;
        ivec3 side = cornerBits(corner);
        result |= spread << uint(side.x + 3 * side.y + 9 * side.z);
    }
    return result;
}
