// Octants around a lattice point on the − side of it along x, y, z; the others are the complement.
const uint kLowOctants[3] = uint[3](0x55u, 0x33u, 0x0Fu);

// Octants around a corner of a cell that are not beyond these sides of it: bits for −x, −y, −z, +x, +y, +z.
uint octantsWithin(int corner, uint sides) {
    uint there = 255u;
    for (int axis = 0; axis < 3; ++axis) {
        bool high = (corner >> axis & 1) != 0;
        uint beyond = high ? kLowOctants[axis] ^ 255u : kLowOctants[axis];
        there &= (sides >> uint(high ? axis + 3 : axis) & 1u) != 0u ? ~beyond : 255u;
    }
    return there;
}
