// Fracture update: decides which of the bonds through a cell's +x, +y, +z faces break. Where its stress lies is the solver's
// affair: the file that includes this defines
//     float principalStress(int cell)          largest principal Cauchy stress of its tetrahedra, Pa, scaled by S
//     mat3 biot(int cell, int tetrahedron)     Biot stress of corner tetrahedron 0..3, Pa
#include "physics/lattice.glsl"
#include "physics/bond.glsl"

uniform float interval;           // s since the last fracture update
uniform samplerBuffer strengths;  // xyz: of the three bonds a cell owns, Pa

float principalStress(int cell);
mat3 biot(int cell, int tetrahedron);

bool overstressed(int cell, uint law) {
    return laws[law].fracture.x < SUNDER_UNBREAKABLE && principalStress(cell) > laws[law].fracture.x;
}

// Corner tetrahedra 0–3 by parity have their apex at these corners (kTetrahedra in src/core/tetrahedra.hpp), and a corner's
// number there is corner >> 1.
const int kApex[8] = int[8](1, 2, 4, 7, 0, 3, 5, 6);

void updateBonds(int cell, inout vec3 damage, inout vec3 slow) {
    uint record = cellRecord(cell);
    uint lawIndex = lawOf(record);
    if (lawIndex == SUNDER_ABSENT) return;
    ivec4 lattice = ivec4(bodyRecord(bodyOf(record)).lattice);
    ivec3 strides = cellStrides(lattice);
    int parity = cellParity(cellCoordinates(cell, lattice));
    bool leaves = overstressed(cell, lawIndex);
    vec3 strength = texelFetch(strengths, cell).xyz;

    for (int axis = 0; axis < 3; ++axis) {
        if (damage[axis] >= 1.0) continue;  // broken, or no neighbour
        int other = cell + strides[axis];
        if (leaves || overstressed(other, lawOf(cellRecord(other)))) {
            damage[axis] = 1.0;
            continue;
        }
        if (strength[axis] >= SUNDER_UNBREAKABLE) continue;
        // The face's two triangles belong to the corner tetrahedra whose apex lies on it, on either side.
        vec2 traction[2];
        int triangle = 0;
        for (int t = 0; t < 4; ++t) {
            int apex = kApex[4 * parity + t];
            if ((apex >> axis & 1) == 0) continue;
            mat3 T = 0.5 * (biot(cell, t) + biot(other, (apex ^ 1 << axis) >> 1));
            traction[triangle++] = faceTraction(T, axis);
        }
        updateBond(laws[lawIndex], traction[0], traction[1], strength[axis], interval, damage[axis], slow[axis]);
    }
}
