// Element update, extended version (thesis, figures 6.4 and 7.2): one point per tetrahedron. Computes the force on each of its
// four nodes and, every few steps, its stress.
#include "physics/lattice.glsl"
#include "physics/elasticity.glsl"
#if FRACTURE
#include "physics/eigen.glsl"
#endif

uniform samplerBuffer nodes;  // NodeRecord
uniform float stepSize;       // s

in ivec4 nodeIndices;  // the finite element structure of chapter 6: four node indices
in mat3 inverseRest;   // and the rest configuration D_m⁻¹, 1/m, along the body's own axes

flat out ivec4 elementNodes;
out vec3 force0;
out vec3 force1;
out vec3 force2;
out vec3 force3;
#if FRACTURE
flat out int elementIndex;
out vec4 principal;       // eigenvector and eigenvalue (Pa) of the largest principal stress
out vec3 biotNormal;      // T_xx, T_yy, T_zz, Pa
out vec3 biotShear;       // T_xy, T_yz, T_zx, Pa
#endif

// Along the body's own axes, as all vectors here but the forces: so F is exactly the identity at rest, whatever they are.
#ifdef TURNED
mat3 axes;
vec3 displacementOf(int node) { return texelFetch(nodes, 2 * node).xyz * axes; }
vec3 velocityOf(int node) { return texelFetch(nodes, 2 * node + 1).xyz * axes; }
#else
vec3 displacementOf(int node) { return texelFetch(nodes, 2 * node).xyz; }
vec3 velocityOf(int node) { return texelFetch(nodes, 2 * node + 1).xyz; }
#endif

// What turns the forces of a cell back: all its tetrahedra work it out of the central one's nodes.
mat3 backOf(int cell, ElementLaw law) {
    int parity = parityOf(cellRecord(cell));
    vec3 half_ = 0.5 / law.cellSize.xyz;
    if (parity != 0) half_.x = -half_.x;  // the mirrored split
    int a = 8 * cell + parity, b = 8 * cell + (3 ^ parity), c = 8 * cell + (5 ^ parity), d = 8 * cell + (6 ^ parity);
    mat3 F = mat3(1.0) + centralGradient(displacementOf(a), displacementOf(b), displacementOf(c), displacementOf(d), half_);
    mat3 rate = centralGradient(velocityOf(a), velocityOf(b), velocityOf(c), velocityOf(d), half_);
    return turnedBack(law, F, rate, stepSize);
}

void main() {
    int cell = gl_VertexID / 5, tetrahedron = gl_VertexID % 5;
    elementNodes = nodeIndices;
    uint lawIndex = lawOf(cellRecord(cell));
    if (lawIndex == SUNDER_ABSENT) {
        force0 = force1 = force2 = force3 = vec3(0.0);
#if FRACTURE
        elementIndex = gl_VertexID;
        principal = vec4(0.0);
        biotNormal = biotShear = vec3(0.0);
#endif
        return;
    }
    ElementLaw law = laws[lawIndex];
#ifdef TURNED
    axes = bodyAxes(bodyRecord(bodyOf(cellRecord(cell))));
#endif
    vec3 u0 = displacementOf(nodeIndices.x), v0 = velocityOf(nodeIndices.x);
    mat3 displacement = mat3(displacementOf(nodeIndices.y) - u0, displacementOf(nodeIndices.z) - u0,
                             displacementOf(nodeIndices.w) - u0);
    mat3 velocity = mat3(velocityOf(nodeIndices.y) - v0, velocityOf(nodeIndices.z) - v0,
                         velocityOf(nodeIndices.w) - v0);
    mat3 F = mat3(1.0) + displacement * inverseRest;
    ElementStress stress = elementStress(law, F, velocity * inverseRest, stepSize, FRACTURE != 0);

    float volume = law.cellSize.w * (tetrahedron == 4 ? 1.0 / 3.0 : 1.0 / 6.0);
    mat3 forces = -volume * backOf(cell, law) * stress.piola * transpose(inverseRest);
#ifdef TURNED
    forces = axes * forces;
#endif
    force1 = forces[0];
    force2 = forces[1];
    force3 = forces[2];
    force0 = -(force1 + force2 + force3);
#if FRACTURE
    elementIndex = gl_VertexID;
    vec3 values;
    mat3 vectors;
    symmetricEigen(scaledCauchyStress(law, F, stress.piola), values, vectors);
    principal = vec4(vectors[0], values.x);
    mat3 T = biotStress(stress);
    biotNormal = vec3(T[0][0], T[1][1], T[2][2]);
    biotShear = vec3(T[0][1], T[1][2], T[2][0]);
#endif
}
