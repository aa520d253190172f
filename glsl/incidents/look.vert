// Look for incidents, one point per cell: which of its bonds broke since the last look, and how hard it was hit
// (src/core/incident.hpp).
#include "contact/sphere.glsl"
#include "incidents/rank.glsl"

#if BUFFERS
uniform samplerBuffer bonds;  // BondRecord
#else
uniform sampler2DArray bonds;  // layers of BondRecord
#endif
uniform samplerBuffer knownBonds;  // as they were at the last look; damage of a cell every 1 + BUFFERS texels
#if CONTACT
// A texel per sphere; x: sum of what it was pushed with, N·s; w: rankOf(). Since the last look, and in the two before.
uniform sampler2DArray pushes, pushesBefore, pushesEarlier;
uniform float blowSpeed;  // m/s
#endif

flat out int cell;
flat out int broken;     // a bit for each bond it owns
flat out float impulse;  // N·s; 0: not worth a word
flat out uint partner;

vec3 damageNow() {
#if BUFFERS
    return texelFetch(bonds, 2 * cell).xyz;
#else
    return texelFetch(bonds, ivec3(texelAddress(cell), 0), 0).xyz;
#endif
}

void main() {
    cell = gl_VertexID;
    broken = 0;
    impulse = 0.0;
    partner = kNobody;
    uvec4 record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return;
    vec3 now = damageNow(), before = texelFetch(knownBonds, (1 + BUFFERS) * cell).xyz;
    for (int axis = 0; axis < 3; ++axis)
        if (before[axis] < 1.0 && now[axis] >= 1.0) broken |= 1 << axis;
#if CONTACT
    float sum = 0.0, sumBefore = 0.0, sumEarlier = 0.0, hardest = 0.0;
    for (int i = 0; i < 1 << SPHERE_BITS; ++i) {
        ivec3 texel = ivec3(sphereAddress(cell << SPHERE_BITS | i), 0);
        vec4 some = texelFetch(pushes, texel, 0);
        sum += some.x;
        hardest = max(hardest, some.w);
        sumBefore += texelFetch(pushesBefore, texel, 0).x;
        sumEarlier += texelFetch(pushesEarlier, texel, 0).x;
    }
    float blow = sum - min(sumBefore, sumEarlier);
    if (blow > 0.0 && blow >= 8.0 * blowSpeed * cornerMass(record)) {
        impulse = blow;
        partner = partnerOf(hardest);
    }
#endif
}
