// Fracture update (thesis, figure 7.3): one vertex per cell. Decides which of the bonds through its +x, +y, +z faces break; the
// state goes back by transform feedback. Where a cell's stress lies is the solver's affair: the file that includes this defines
//     float principalStress(int cell)          largest principal Cauchy stress of its tetrahedra, Pa, scaled by S
//     mat3 biot(int cell, int tetrahedron)     Biot stress of corner tetrahedron 0..3, Pa
#include "physics/lattice.glsl"
#include "physics/bond.glsl"

uniform float interval;  // s since the last fracture update

in vec4 damage;    // of the three bonds this cell owns
in vec4 slow;      // Pa
in vec4 strength;  // Pa
out vec4 newDamage;
out vec4 newSlow;

float principalStress(int cell);
mat3 biot(int cell, int tetrahedron);

bool overstressed(int cell, uint law) {
    return laws[law].fracture.x < SUNDER_UNBREAKABLE && principalStress(cell) > laws[law].fracture.x;
}

// Corner tetrahedra 0–3 by parity have their apex at these corners (kTetrahedra in src/core/tetrahedra.hpp), and a corner's
// number there is corner >> 1.
const int kApex[8] = int[8](1, 2, 4, 7, 0, 3, 5, 6);

void main() {
    vec3 d = damage.xyz, s = slow.xyz;
    newDamage = damage;
    newSlow = slow;
    uint record = cellRecord(gl_VertexID);
    uint lawIndex = lawOf(record);
    if (lawIndex == SUNDER_ABSENT) return;
    ivec4 lattice = ivec4(bodyRecord(bodyOf(record)).lattice);
    ivec3 strides = cellStrides(lattice);
    int parity = cellParity(cellCoordinates(gl_VertexID, lattice));
    bool leaves = overstressed(gl_VertexID, lawIndex);

    for (int axis = 0; axis < 3; ++axis) {
        if (d[axis] >= 1.0) continue;  // broken, or no neighbour
        int other = gl_VertexID + strides[axis];
        if (leaves || overstressed(other, lawOf(cellRecord(other)))) {
            d[axis] = 1.0;
            continue;
        }
        // The face's two triangles belong to the corner tetrahedra whose apex lies on it, on either side.
        vec2 traction[2];
        int triangle = 0;
        for (int t = 0; t < 4; ++t) {
            int apex = kApex[4 * parity + t];
            if ((apex >> axis & 1) == 0) continue;
            mat3 T = 0.5 * (biot(gl_VertexID, t) + biot(other, (apex ^ 1 << axis) >> 1));
            traction[triangle++] = faceTraction(T, axis);
        }
        updateBond(laws[lawIndex], traction[0], traction[1], strength[axis], interval, d[axis], s[axis]);
    }
    newDamage = vec4(d, 0.0);
    newSlow = vec4(s, 0.0);
}
