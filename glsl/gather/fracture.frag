// Fracture update: one fragment per cell, damage and slow traction into two float targets.
#include "gather/cell_texel.glsl"
#include "gather/stress.glsl"
#include "physics/fracture.glsl"

uniform sampler2DArray stresses;  // layers of a stress record
uniform sampler2DArray bonds;     // layers of BondRecord

uniform bool newWatch;  // this is the first update since bodies were last looked at for rest

#ifdef COMPUTE
vec4 newDamage, newSlow;
#else
layout(location = 0) out vec4 newDamage;  // w: 1 where damage grew since then
layout(location = 1) out vec4 newSlow;
#endif

vec4 stressLayer(int cell, int layer) { return texelFetch(stresses, ivec3(texelAddress(cell), layer), 0); }

float principalStress(int cell) {
#if CELLS_BREAK
    return stressLayer(cell, kPrincipalLayer).x;
#else
    return 0.0;
#endif
}

float slowStress(int cell) { return texelFetch(bonds, ivec3(texelAddress(cell), 1), 0).w; }

mat3 biot(int cell, int tetrahedron) {
#if BONDS_BREAK
    vec4 a = stressLayer(cell, tetrahedron), pair = stressLayer(cell, 4 + tetrahedron / 2);
    vec2 b = tetrahedron % 2 == 0 ? pair.xy : pair.zw;
    return mat3(a.x, a.w, b.y, a.w, a.y, b.x, b.y, b.x, a.z);
#else
    return mat3(0.0);
#endif
}

void updateCell(int cell, ivec2 texel) {
    newDamage = texelFetch(bonds, ivec3(texel, 0), 0);
    newSlow = texelFetch(bonds, ivec3(texel, 1), 0);
    vec3 before = newDamage.xyz, d = before;
    updateBonds(cell, d, newSlow);
    bool grew = any(notEqual(d, before)) || (!newWatch && newDamage.w > 0.0);
    newDamage = vec4(d, grew ? 1.0 : 0.0);
}

#ifdef COMPUTE
void main() {
    int cell = invocationCell();
    if (cell < 0) return;
    ivec2 texel = texelAddress(cell);
    updateCell(cell, texel);
    imageStore(target, ivec3(texel, 0), newDamage);
    imageStore(target, ivec3(texel, 1), newSlow);
}
#else
void main() { updateCell(fragmentIndex(), ivec2(gl_FragCoord.xy)); }
#endif
