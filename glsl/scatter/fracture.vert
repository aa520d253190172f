// Fracture update (thesis, figure 7.3): one vertex per cell, the state fed back by transform feedback.
#include "physics/fracture.glsl"
#include "scatter/textures.glsl"

uniform sampler2D stresses;
uniform samplerBuffer bonds;  // BondRecord, as the last update left it

in vec4 damage;  // of the three bonds this cell owns
in vec4 slow;    // Pa, of their tractions; w: of the cell's stress
out vec4 newDamage;
out vec4 newSlow;

vec4 stressTexel(int cell, int tetrahedron, int texel) {
    return texelFetch(stresses, texelAddress(SUNDER_STRESS_TEXELS * (5 * cell + tetrahedron) + texel), 0);
}

float principalStress(int cell) {
    float largest = stressTexel(cell, 0, SUNDER_STRESS_PRINCIPAL).a;
    for (int t = 1; t < 5; ++t) largest = max(largest, stressTexel(cell, t, SUNDER_STRESS_PRINCIPAL).a);
    return largest;
}

float slowStress(int cell) { return texelFetch(bonds, 2 * cell + 1).w; }

mat3 biot(int cell, int tetrahedron) {
    vec3 n = stressTexel(cell, tetrahedron, SUNDER_STRESS_NORMAL).xyz;
    vec3 s = stressTexel(cell, tetrahedron, SUNDER_STRESS_SHEAR).xyz;
    return mat3(n.x, s.x, s.z, s.x, n.y, s.y, s.z, s.y, n.z);
}

void main() {
    vec3 d = damage.xyz;
    newSlow = slow;
    newDamage = damage;
    if (damage.w == SUNDER_GONE) return;
    updateBonds(gl_VertexID, d, newSlow);
    newDamage = vec4(d, 0.0);
}
