// Cells, bodies and lattice coordinates. Cells of a body are numbered densely, x fastest, so neighbours follow from the lattice.
#include "shared/layout.h"

uniform usamplerBuffer cells;  // one texel per cell: law | body << SUNDER_LAW_BITS
uniform samplerBuffer bodies;  // SUNDER_BODY_TEXELS per body

layout(std140) uniform ElementLaws { ElementLaw laws[SUNDER_MAX_ELEMENT_LAWS]; };

uint cellRecord(int cell) { return texelFetch(cells, cell).r; }
uint lawOf(uint record) { return record & ((1u << SUNDER_LAW_BITS) - 1u); }
int bodyOf(uint record) { return int(record >> SUNDER_LAW_BITS); }

BodyRecord bodyRecord(int body) {
    int first = SUNDER_BODY_TEXELS * body;
    return BodyRecord(texelFetch(bodies, first), texelFetch(bodies, first + 1), texelFetch(bodies, first + 2),
                      texelFetch(bodies, first + 3));
}

ivec3 cellCoordinates(int cell, ivec4 lattice) {
    int local = cell - lattice.w;
    return ivec3(local % lattice.x, local / lattice.x % lattice.y, local / (lattice.x * lattice.y));
}

// Steps in the cell numbering for one cell along x, y, z.
ivec3 cellStrides(ivec4 lattice) { return ivec3(1, lattice.x, lattice.x * lattice.y); }

ivec3 cornerBits(int corner) { return ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1); }

// Which of the two mirrored splits into tetrahedra a cell has: parity of i+j+k.
int cellParity(ivec3 coordinates) { return (coordinates.x + coordinates.y + coordinates.z) & 1; }

// Columns of the solver's textures; texels are numbered row by row, for a 1D texture would end at 16,384.
uniform int textureWidth;

ivec2 texelAddress(int index) { return ivec2(index % textureWidth, index / textureWidth); }
