// Fracture update: decides which of the bonds through a cell's +x, +y, +z faces break. Where its stress lies is the solver's
// affair: a place is a cell's number, or whatever the file that includes this takes it for, which defines
//     float principalStress(int place)         largest principal Cauchy stress of its tetrahedra, Pa, scaled by S
//     float slowStress(int place)              slow part of that, Pa, not scaled, as the last update left it
//     mat3 biot(int place, int tetrahedron)    Biot stress of corner tetrahedron 0..3, Pa
#include "physics/lattice.glsl"
#include "physics/bond.glsl"

uniform float interval;           // s since the last fracture update
uniform samplerBuffer strengths;  // xyz: of the three bonds a cell owns, Pa

float principalStress(int place);
float slowStress(int place);
mat3 biot(int place, int tetrahedron);

// As with bonds, only what exceeds the slow part of the stress is scaled by S.
bool overstressed(int place, uint law) {
    float limit = laws[law].fracture.x, S = laws[law].elasticity.w;
    if (limit >= SUNDER_UNBREAKABLE) return false;
    float stress = principalStress(place);
    if (S > 1.0) stress = slowStress(place) + max(0.0, stress - S * slowStress(place));
    return stress > limit;
}

// The two triangles of the face between a cell and its neighbour along an axis belong to the corner tetrahedra whose apex lies on
// it, on either side (kTetrahedra in src/core/tetrahedra.hpp). By 3·parity + axis: first and second of the cell, of the neighbour.
const ivec4 kFace[6] = ivec4[6](ivec4(0, 3, 0, 3), ivec4(1, 3, 0, 2), ivec4(2, 3, 0, 1),  //
                                ivec4(1, 2, 1, 2), ivec4(1, 3, 0, 2), ivec4(2, 3, 0, 1));

// One bond of a cell; axis is a constant wherever this is called, so that the compiler indexes nothing at run time. other: the cell
// beyond it; place, otherPlace: of both.
void updateBondAlong(int axis, int other, int place, int otherPlace, int parity, ElementLaw law, bool leaves, float strength,
                     inout float damage, inout float slow) {
    if (damage >= 1.0) return;  // broken, or no neighbour
    if (leaves || overstressed(otherPlace, lawOf(cellRecord(other)))) {
        damage = 1.0;
        return;
    }
    if (strength >= SUNDER_UNBREAKABLE) return;
    ivec4 face = kFace[3 * parity + axis];
    vec2 first = faceTraction(0.5 * (biot(place, face.x) + biot(otherPlace, face.z)), axis);
    vec2 second = faceTraction(0.5 * (biot(place, face.y) + biot(otherPlace, face.w)), axis);
    updateBond(law, first, second, strength, interval, damage, slow);
}

// slow: of the bonds' tractions; w: of the cell's largest principal stress, where it breaks by that and S is more than 1. steps: from
// its place to those of its neighbours along x, y, z.
void updateBonds(int cell, int place, ivec3 steps, inout vec3 damage, inout vec4 slow) {
    uvec4 record = cellRecord(cell);
    uint lawIndex = lawOf(record);
    if (lawIndex == SUNDER_ABSENT) return;
    ElementLaw law = laws[lawIndex];
    ivec3 strides = cellStrides(ivec4(bodyRecord(bodyOf(record)).lattice));
    int parity = parityOf(record);
    bool leaves = overstressed(place, lawIndex);
    vec3 strength = texelFetch(strengths, cell).xyz;
    updateBondAlong(0, cell + strides.x, place, place + steps.x, parity, law, leaves, strength.x, damage.x, slow.x);
    updateBondAlong(1, cell + strides.y, place, place + steps.y, parity, law, leaves, strength.y, damage.y, slow.y);
    updateBondAlong(2, cell + strides.z, place, place + steps.z, parity, law, leaves, strength.z, damage.z, slow.z);
    if (law.fracture.x < SUNDER_UNBREAKABLE && law.elasticity.w > 1.0)
        slow.w += (max(0.0, principalStress(place) / law.elasticity.w) - slow.w) * slowShare(interval);
}

// Where a cell's number is its place.
void updateBonds(int cell, inout vec3 damage, inout vec4 slow) {
    updateBonds(cell, cell, cellStrides(ivec4(bodyRecord(bodyOf(cellRecord(cell))).lattice)), damage, slow);
}
