// Fracture update: one fragment per cell, damage and slow traction into two float targets.
#include "gather/cell_texel.glsl"
#include "gather/stress.glsl"
#include "physics/fracture.glsl"

uniform sampler2DArray stresses;  // layers of a stress record
uniform sampler2DArray bonds;     // layers of BondRecord

layout(location = 0) out vec4 newDamage;
layout(location = 1) out vec4 newSlow;

vec4 stressLayer(int cell, int layer) { return texelFetch(stresses, ivec3(texelAddress(cell), layer), 0); }

float principalStress(int cell) { return stressLayer(cell, 6).x; }

mat3 biot(int cell, int tetrahedron) {
    vec4 a = stressLayer(cell, tetrahedron), pair = stressLayer(cell, 4 + tetrahedron / 2);
    vec2 b = tetrahedron % 2 == 0 ? pair.xy : pair.zw;
    return mat3(a.x, a.w, b.y, a.w, a.y, b.x, b.y, b.x, a.z);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    newDamage = texelFetch(bonds, ivec3(texel, 0), 0);
    newSlow = texelFetch(bonds, ivec3(texel, 1), 0);
    int cell = fragmentIndex();
    if (cell >= cellCount) return;
    vec3 d = newDamage.xyz, s = newSlow.xyz;
    updateBonds(cell, d, s);
    newDamage.xyz = d;
    newSlow.xyz = s;
}
