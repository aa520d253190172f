// One point per cell (thesis, figure 6.6): finds out which of its six faces are to be seen; the geometry shader makes them.
#include "shared/layout.h"

uniform usamplerBuffer cells;
uniform samplerBuffer bodies;
uniform samplerBuffer bonds;

// Face 2·axis + side, side 1 on the positive side.
flat out int cell;
flat out uint law;
flat out uint open;     // bit per face: no cell beyond it, or the bond with that cell is broken
flat out uint broken;   // bit per face: there is a cell beyond it, but the bond is broken
flat out uint parity_;  // of i + j + k: which of the two splits into tetrahedra

uint lawOf(int c) {
    return texelFetch(cells, c).r & uint((1 << SUNDER_LAW_BITS) - 1);
}

void main() {
    cell = gl_VertexID;
    law = lawOf(cell);
    open = 0u;
    broken = 0u;
    parity_ = 0u;
    if (law == SUNDER_ABSENT) return;

    int body = int(texelFetch(cells, cell).r >> SUNDER_LAW_BITS);
    ivec4 lattice = ivec4(texelFetch(bodies, SUNDER_BODY_TEXELS * body));
    int local = cell - lattice.w;
    ivec3 c = ivec3(local % lattice.x, (local / lattice.x) % lattice.y, local / (lattice.x * lattice.y));
    parity_ = uint(c.x + c.y + c.z) & 1u;

    vec4 own = texelFetch(bonds, 2 * cell);
    int stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            uint bit = 1u << uint(2 * axis + side);
            bool edge = side == 0 ? c[axis] == 0 : c[axis] == lattice[axis] - 1;
            if (edge) {
                open |= bit;
                continue;
            }
            int neighbour = side == 0 ? cell - stride : cell + stride;
            float damage = side == 0 ? texelFetch(bonds, 2 * neighbour)[axis] : own[axis];
            if (damage < 1.0) continue;
            open |= bit;
            if (lawOf(neighbour) != SUNDER_ABSENT) broken |= bit;
        }
        stride *= lattice[axis];
    }
}
