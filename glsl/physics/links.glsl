// Which of the eight octants around a lattice point hang together. held.x, .y, .z: bit o set while the bond from octant o to
// its neighbour on the +x, +y, +z side holds (only octants with that bit clear own one).
//
// Each sweep spreads the set through all bonds of one axis at a time by shifts; the longest detour through the cube's twelve
// edges needs five sweeps (the test walks all 4,096 states).
uint linkMask(uvec3 held, int octant) {
    uint mask = 1u << uint(octant);
    for (int sweep = 0; sweep < 5; ++sweep) {
        mask |= (mask & held.x) << 1u | (mask >> 1u & held.x);
        mask |= (mask & held.y) << 2u | (mask >> 2u & held.y);
        mask |= (mask & held.z) << 4u | (mask >> 4u & held.z);
    }
    return mask;
}

// Link mask of corner 0..7 out of a LinkRecord's masks.
uint linkMaskOf(vec4 masks, int corner) { return uint(masks[corner >> 1]) >> uint(8 * (corner & 1)) & 255u; }
