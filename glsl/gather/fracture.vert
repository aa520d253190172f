// The fracture update on the gather solver's stress buffer.
#include "physics/fracture.glsl"
#include "gather/stress.glsl"

uniform samplerBuffer stresses;

float principalStress(int cell) { return texelFetch(stresses, SUNDER_STRESS_RECORD * cell + 6).x; }

mat3 biot(int cell, int tetrahedron) {
    vec4 a = texelFetch(stresses, SUNDER_STRESS_RECORD * cell + tetrahedron);
    vec4 pair = texelFetch(stresses, SUNDER_STRESS_RECORD * cell + 4 + tetrahedron / 2);
    vec2 b = tetrahedron % 2 == 0 ? pair.xy : pair.zw;
    return mat3(a.x, a.w, b.y, a.w, a.y, b.x, b.y, b.x, a.z);
}
