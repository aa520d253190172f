// Element update: one fragment (or invocation) per cell computes its five tetrahedra and writes the forces on its eight nodes into
// eight float targets; with STRESSES, every few steps, the stresses that bonds are tested with instead.
//
// On a box cell nothing but edge lengths is needed (no rest matrices): in a corner tetrahedron the columns of F are the three
// edges at its apex over their lengths, in the central one half sums and differences of its four corners. All vectors are along the
// body's own axes, so that F is exactly the identity at rest, whatever they are.
#include "gather/cell_texel.glsl"
#include "gather/node.glsl"
#include "physics/lattice.glsl"
#include "physics/elasticity.glsl"
#include "physics/step.glsl"
#if STRESSES
#include "gather/stress.glsl"
#include "physics/eigen.glsl"
#endif

#ifndef COMPUTE
layout(location = 0) out
#endif
#if STRESSES
vec4 newStress[kStressLayers];
#else
vec4 newForces[8];  // xyz: N, on this cell's copies of its nodes
#endif

vec3 u[8], v[8], f[8];

#if STRESSES && CELLS_BREAK
float largestPrincipal = -1.0e30;

void addPrincipal(ElementLaw law, mat3 F, mat3 piola) {
    if (law.fracture.x >= SUNDER_UNBREAKABLE) return;  // nothing asks for it
    vec3 values;
    mat3 vectors;
    symmetricEigen(scaledCauchyStress(law, F, piola), values, vectors);
    largestPrincipal = max(largestPrincipal, values.x);
}
#endif

// a: apex; x, y, z: its neighbours along the axes; toward: signed reciprocal edge lengths, 1/m, away from the apex.
ElementStress cornerTetrahedron(ElementLaw law, int a, int x, int y, int z, vec3 toward) {
    mat3 displacement = mat3((u[x] - u[a]) * toward.x, (u[y] - u[a]) * toward.y, (u[z] - u[a]) * toward.z);
    mat3 rate = mat3((v[x] - v[a]) * toward.x, (v[y] - v[a]) * toward.y, (v[z] - v[a]) * toward.z);
    mat3 F = mat3(1.0) + displacement;
    ElementStress stress = elementStress(law, F, rate, stepSize, STRESSES != 0);
    float volume = law.cellSize.w / 6.0;
    vec3 fx = stress.piola[0] * (-volume * toward.x);
    vec3 fy = stress.piola[1] * (-volume * toward.y);
    vec3 fz = stress.piola[2] * (-volume * toward.z);
    f[x] += fx;
    f[y] += fy;
    f[z] += fz;
    f[a] -= fx + fy + fz;
#if STRESSES && CELLS_BREAK
    addPrincipal(law, F, stress.piola);
#endif
    return stress;
}

// Returns what turns the cell's forces back.
mat3 centralTetrahedron(ElementLaw law, vec3 reciprocal) {
    vec3 half_ = 0.5 * reciprocal;
    mat3 F = mat3(1.0) + centralGradient(u[0], u[3], u[5], u[6], half_);
    mat3 rate = centralGradient(v[0], v[3], v[5], v[6], half_);
    ElementStress stress = elementStress(law, F, rate, stepSize, STRESSES != 0);
    float volume = law.cellSize.w / 3.0;
    vec3 fx = stress.piola[0] * (-volume * half_.x);
    vec3 fy = stress.piola[1] * (-volume * half_.y);
    vec3 fz = stress.piola[2] * (-volume * half_.z);
    f[0] -= fx + fy + fz;
    f[3] += fx + fy - fz;
    f[5] += fx - fy + fz;
    f[6] += fy + fz - fx;
#if STRESSES && CELLS_BREAK
    addPrincipal(law, F, stress.piola);
#endif
    return turnedBack(law, F, rate, stepSize);
}

void updateCell(int cell, ivec2 texel) {
#if STRESSES
    for (int i = 0; i < kStressLayers; ++i) newStress[i] = vec4(0.0);
#else
    for (int k = 0; k < 8; ++k) newForces[k] = vec4(0.0);
#endif
    uvec4 record = cellRecord(cell);
    uint lawIndex = lawOf(record);
    if (lawIndex == SUNDER_ABSENT) return;
    ElementLaw law = laws[lawIndex];
    int parity = parityOf(record);
    // An odd cell is an even one seen in a mirror across x: corner k stands for k ^ 1, and x runs backwards.
    for (int k = 0; k < 8; ++k) {
        u[k] = texelFetch(nodes, ivec3(texel, displacementLayer(k ^ parity)), 0).xyz;
        v[k] = texelFetch(nodes, ivec3(texel, velocityLayer(k ^ parity)), 0).xyz;
        f[k] = vec3(0.0);
    }
#ifdef TURNED
    mat3 axes = bodyAxes(bodyRecord(bodyOf(record)));
    for (int k = 0; k < 8; ++k) {
        u[k] = u[k] * axes;
        v[k] = v[k] * axes;
    }
#endif
    vec3 r = 1.0 / law.cellSize.xyz;
    if (parity != 0) r.x = -r.x;

    ElementStress s1 = cornerTetrahedron(law, 1, 0, 3, 5, vec3(-r.x, r.y, r.z));
    ElementStress s2 = cornerTetrahedron(law, 2, 3, 0, 6, vec3(r.x, -r.y, r.z));
    ElementStress s4 = cornerTetrahedron(law, 4, 5, 6, 0, vec3(r.x, r.y, -r.z));
    ElementStress s7 = cornerTetrahedron(law, 7, 6, 5, 3, vec3(-r.x, -r.y, -r.z));
#if STRESSES
#if CELLS_BREAK
    centralTetrahedron(law, r);
    newStress[kPrincipalLayer].x = largestPrincipal;
#endif
#if BONDS_BREAK
    mat3 T0 = biotStress(s1), T1 = biotStress(s2), T2 = biotStress(s4), T3 = biotStress(s7);
    newStress[0] = vec4(T0[0][0], T0[1][1], T0[2][2], T0[0][1]);
    newStress[1] = vec4(T1[0][0], T1[1][1], T1[2][2], T1[0][1]);
    newStress[2] = vec4(T2[0][0], T2[1][1], T2[2][2], T2[0][1]);
    newStress[3] = vec4(T3[0][0], T3[1][1], T3[2][2], T3[0][1]);
    newStress[4] = vec4(T0[1][2], T0[2][0], T1[1][2], T1[2][0]);
    newStress[5] = vec4(T2[1][2], T2[2][0], T3[1][2], T3[2][0]);
#endif
#else
    mat3 back = centralTetrahedron(law, r);
#ifdef TURNED
    back = axes * back;
#endif
    for (int k = 0; k < 8; k += 2) {
        newForces[k] = vec4(back * (parity == 0 ? f[k] : f[k + 1]), 0.0);
        newForces[k + 1] = vec4(back * (parity == 0 ? f[k + 1] : f[k]), 0.0);
    }
#endif
}

#ifdef COMPUTE
void main() {
    int cell = invocationCell();
    if (cell < 0) return;
    ivec2 texel = texelAddress(cell);
    updateCell(cell, texel);
#if STRESSES
    for (int i = 0; i < kStressLayers; ++i) imageStore(target, ivec3(texel, i), newStress[i]);
#else
    for (int k = 0; k < 8; ++k) imageStore(target, ivec3(texel, k), newForces[k]);
#endif
}
#else
void main() { updateCell(fragmentIndex(), ivec2(gl_FragCoord.xy)); }
#endif
