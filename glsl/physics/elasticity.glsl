// First Piola–Kirchhoff stress of one tetrahedron from its deformation gradient F and rate Ḟ.
#include "shared/layout.h"
#include "physics/polar.glsl"

const float kDamping = 0.1;     // b: stress is taken from G = F + b·h·Ḟ (stiffness-proportional damping)
const float kHotDamping = 0.5;  // b of strongly deformed elements

struct ElementStress {
    mat3 piola;     // P, Pa
    mat3 rotation;  // R of G
};

ElementStress elementStress(ElementLaw law, mat3 F, mat3 rate, float h) {
    float viscosity = law.viscosity.x;
    bool hot = determinant(F) < (viscosity > 0.0 ? 0.5 : 0.3) || dot(F[0], F[0]) + dot(F[1], F[1]) + dot(F[2], F[2]) > 6.0;
    mat3 G = F + (hot ? kHotDamping : kDamping) * h * rate;
    mat3 R = polarRotation(G);
    float lambda = law.elasticity.x, mu = law.elasticity.y;
    mat3 P;
    if (law.elasticity.z == SUNDER_LAW_COROTATED) {
        float dilation = dot(R[0], G[0]) + dot(R[1], G[1]) + dot(R[2], G[2]) - 3.0;
        P = 2.0 * mu * (G - R) + lambda * dilation * R;
    } else {
        // Green's strain (thesis, eq. 2.2): E = ½(GᵀG − I), S = 2μE + λ·tr(E)·I, P = G·S.
        mat3 strain = 0.5 * (transpose(G) * G - mat3(1.0));
        float dilation = strain[0][0] + strain[1][1] + strain[2][2];
        P = G * (2.0 * mu * strain + mat3(lambda * dilation));
    }
    if (hot && viscosity > 0.0)
        P += viscosity * rate;
    else if (hot)  // keeps the stability limit E·(1+2b) where b is larger
        P *= (1.0 + 2.0 * kDamping) / (1.0 + 2.0 * kHotDamping);
    return ElementStress(P, R);
}

// Biot stress in the material frame, T = sym(RᵀP), Pa: what bonds are tested with.
mat3 biotStress(ElementStress stress) {
    mat3 T = transpose(stress.rotation) * stress.piola;
    return 0.5 * (T + transpose(T));
}

// Cauchy stress times √(E/E_eff), Pa: its largest eigenvalue is what `fracture = "cell"` compares with maxStress.
mat3 scaledCauchyStress(ElementLaw law, mat3 F, mat3 piola) {
    mat3 kirchhoff = piola * transpose(F);
    return 0.5 * law.elasticity.w / max(determinant(F), 0.05) * (kirchhoff + transpose(kirchhoff));
}
