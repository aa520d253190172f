// First Piola–Kirchhoff stress of one tetrahedron from its deformation gradient F and rate Ḟ.
#include "shared/constants.h"
#include "shared/layout.h"
#include "physics/polar.glsl"

struct ElementStress {
    mat3 piola;     // P, Pa
    mat3 rotation;  // R of G; of Green's law only where it was asked for
};

float squaredNorm(mat3 m) { return dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]); }

// Strongly deformed.
bool isHot(ElementLaw law, mat3 F) {
    return determinant(F) < (law.extremes.x > 0.0 ? 0.5 : 0.3) || squaredNorm(F) > 6.0;
}

// Damping takes the stress from where the nodes will be b·h later. By then a cell that spins has turned on, and so have the
// forces: they would brake it by b·h·ω² a second. This rotation turns the forces of a cell back, as far as its central tetrahedron
// turns; none where that does not turn as one (src/core/elasticity.hpp).
mat3 turnedBack(ElementLaw law, mat3 F, mat3 rate, float h) {
    mat3 change = kDamping * h * rate;
    bool asOne = squaredNorm(change) < kMostTurn2 && squaredNorm(F) < kMostStretch2;
    return !isHot(law, F) && asOne ? gramSchmidt(F) * transpose(gramSchmidt(F + change)) : mat3(1.0);
}

// Columns of the gradient of a field on a cell's central tetrahedron 0, 3, 5, 6; half: half reciprocal edge lengths.
mat3 centralGradient(vec3 a0, vec3 a3, vec3 a5, vec3 a6, vec3 half_) {
    vec3 first = a3 - a6, second = a5 - a0;
    return mat3((first + second) * half_.x, (a3 + a6 - a5 - a0) * half_.y, (second - first) * half_.z);
}

// rotated: whether R is wanted, too.
ElementStress elementStress(ElementLaw law, mat3 F, mat3 rate, float h, bool rotated) {
    float viscosity = law.extremes.x;
    bool hot = isHot(law, F);
    mat3 G = F + (hot ? kHotDamping : kDamping) * h * rate;
    bool corotated = law.elasticity.z == SUNDER_LAW_COROTATED;
    mat3 R = mat3(1.0);
    if (corotated || rotated) R = polarRotation(G);
    float lambda = law.elasticity.x, mu = law.elasticity.y;
    mat3 P;
    if (corotated) {
        float dilation = dot(R[0], G[0]) + dot(R[1], G[1]) + dot(R[2], G[2]) - 3.0;
        P = 2.0 * mu * (G - R) + lambda * dilation * R;
    } else {
        // Green's strain (thesis, eq. 2.2): E = ½(GᵀG − I), S = 2μE + λ·tr(E)·I, P = G·S.
        mat3 strain = 0.5 * (transpose(G) * G - mat3(1.0));
        float dilation = strain[0][0] + strain[1][1] + strain[2][2];
        P = G * (2.0 * mu * strain + mat3(lambda * dilation));
        float size = sqrt(squaredNorm(P)), most = law.extremes.y;
        if (size > most) P *= most / size;
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
