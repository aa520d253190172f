// `fracture = "bond"`: a face between two cells breaks by traction and damage (docs/fracture.md, points 3 to 7).
#include "shared/constants.h"
#include "shared/layout.h"

// Traction on one of the face's two triangles: T is the mean Biot stress (material frame) of the two corner tetrahedra that
// meet there. x: normal, y: shear, Pa.
vec2 faceTraction(mat3 T, int axis) {
    int b = (axis + 1) % 3, c = (axis + 2) % 3;
    return vec2(T[axis][axis], length(vec2(T[axis][b], T[axis][c])));
}

// Share of what is new in a stress that its slow part takes up in `interval` seconds.
float slowShare(float interval) { return min(1.0, interval / kSlowTime); }

// Advances damage and the slow part of the traction of one bond by `interval` seconds. The difference of the two normal
// tractions catches bending; only what exceeds the slow part is scaled by S = √(E/E_eff), or dead weight would be too.
void updateBond(ElementLaw law, vec2 first, vec2 second, float strength, float interval, inout float damage,
                inout float slow) {
    if (damage >= 1.0 || strength >= SUNDER_UNBREAKABLE) return;
    float S = law.elasticity.w;
    float beta = law.fracture.z, friction = law.fracture.w;
    float tn = S * (0.5 * (first.x + second.x) + abs(first.x - second.x));
    float ts = max(0.0, S * 0.5 * (first.y + second.y) - friction * max(-tn, 0.0));
    float tension = max(tn, 0.0);
    float unscaled = sqrt(tension * tension + beta * ts * ts) / S;
    slow += (unscaled - slow) * slowShare(interval);
    float blow = max(0.0, unscaled - slow);
    float ratio = (slow + S * blow) / strength;
    if (ratio > 1.0) damage = min(1.0, damage + interval * law.fracture.y * min(ratio - 1.0, 4.0));
    // A blow so fast that cracks, which keep pace with the waves of the softer material, would come too late.
    if (blow > law.extremes.z && S * S * blow > kSuddenStress * strength) damage = 1.0;
}
