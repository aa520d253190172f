// Cells, bodies and lattice coordinates. Cells of a body are numbered densely, x fastest, so neighbours follow from the lattice.
#include "shared/layout.h"

uniform usamplerBuffer cells;  // one texel per cell: its record
uniform samplerBuffer bodies;  // SUNDER_BODY_TEXELS per body

layout(std140) uniform ElementLaws { ElementLaw laws[SUNDER_MAX_ELEMENT_LAWS]; };

uvec4 cellRecord(int cell) { return texelFetch(cells, cell); }
uint lawOf(uvec4 record) { return record.x & SUNDER_CELL_LAW; }
int bodyOf(uvec4 record) { return int(record.y); }
// kg, of each copy of its nodes.
float cornerMass(uvec4 record) { return uintBitsToFloat(record.z); }
// Which of the two mirrored splits into tetrahedra a cell has: 0 or 1.
int parityOf(uvec4 record) { return (record.x & SUNDER_CELL_ODD) != 0u ? 1 : 0; }

BodyRecord bodyRecord(int body) {
    int first = SUNDER_BODY_TEXELS * body;
    return BodyRecord(texelFetch(bodies, first), texelFetch(bodies, first + 1), texelFetch(bodies, first + 2),
                      texelFetch(bodies, first + 3), texelFetch(bodies, first + 4), texelFetch(bodies, first + 5),
                      texelFetch(bodies, first + 6));
}

// A body's own axes in the world at rest, as columns. TURNED is defined where any body's
// are not the world's; all others do not pay for them, and go through the same operations as if there were none.
mat3 bodyAxes(BodyRecord body) { return mat3(body.axisX.xyz, body.axisY.xyz, body.axisZ.xyz); }

// m, in the world: from a body's origin, or a cell's corner 0, to a place at rest that lies `own` from there along the body's axes.
vec3 alongAxes(BodyRecord body, vec3 own) {
#ifdef TURNED
    return bodyAxes(body) * own;
#else
    return own;
#endif
}

ivec3 cellCoordinates(int cell, ivec4 lattice) {
    int local = cell - lattice.w;
    return ivec3(local % lattice.x, local / lattice.x % lattice.y, local / (lattice.x * lattice.y));
}

// Steps in the cell numbering for one cell along x, y, z.
ivec3 cellStrides(ivec4 lattice) { return ivec3(1, lattice.x, lattice.x * lattice.y); }

ivec3 cornerBits(int corner) { return ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1); }

// Columns of the solver's textures, as a power of two (division is slow); texels are numbered row by row, for a 1D texture would
// end at 16,384.
uniform int textureShift;

ivec2 texelAddress(int index) { return ivec2(index & ((1 << textureShift) - 1), index >> textureShift); }
