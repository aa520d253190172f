#pragma once
#include "core/constants.hpp"
#include "core/element_law.hpp"
#include "core/material.hpp"

namespace sunder::core {

/// κ(ν): the highest angular frequency of a free cubic cell of edge ℓ is κ·√(E/ρ)/ℓ, mass lumped in
/// eighths. Boxes whose shortest edge is ℓ lie below it.
double cellFrequencyFactor(double poissonRatio);

/// Largest Young's modulus, Pa, that steps of h seconds carry on cells whose shortest edge is
/// `edge` m: symplectic Euler with stiffness-proportional damping b needs h²ω²(1+2b) ≤ 4; a factor
/// 0.9 on ω is kept in reserve.
double stableYoungModulus(double density, double edge, double poissonRatio, double h);

/// Rotation R of the polar decomposition G = R·S: the rotation that maximises tr(RᵀG), also when G
/// is singular or inverted.
Mat3 polarRotation(const Mat3& G);

/// Viscosity η, Pa·s, of strongly deformed elements: adds η·Ḟ to their stress. `reserve`: stable
/// Young's modulus over the element's, at least 1. Where it is large, a damping of b·h seconds is
/// next to nothing; η = 2μ·h·v with v in proportion to √reserve decays in about the time a wave
/// takes through a cell. The stability limit asks for 1 + 2·kHotDamping + 2v ≤ reserve·(1 +
/// 2·kDamping). 0 where that leaves nothing: there the stress is scaled down to the limit instead.
double hotViscosity(double mu, double reserve, double h);
/// Largest norm, Pa, that P may have by Green's law, whose stiffness grows with the square of the
/// stretch: ρ·(ℓ/h)²/5, which moves a corner of a cube by about half its edge within a step. A
/// stress scaled down to it leaves forces that still add up to nothing, and turn nothing: momentum
/// is kept. The corotated law is as stiff as it is at rest however an element is deformed, and
/// needs no such bound.
double largestGreenStress(double density, double edge, double h);

/// det F below which an element is strongly deformed: earlier where it has a viscosity to calm it.
double hotDeterminant(double viscosity);

struct ElementStress {
    Mat3 piola;     ///< first Piola–Kirchhoff stress P, Pa
    Mat3 rotation;  ///< R of G
};

/// Stress of one element from its deformation gradient F and its rate Ḟ (1/s) at step h (s),
/// damping and the treatment of strongly deformed ("hot") elements included.
ElementStress elementStress(const ElementLaw&, ConstitutiveLaw, const Mat3& F, const Mat3& rate,
                            double h);

/// Damping takes the stress from where the nodes will be b·h later. By then a cell that spins has
/// turned on, and so have the forces: they would brake it by b·h·ω² a second. This rotation turns
/// the forces of a cell back, as far as its central tetrahedron turns; none where that is strongly
/// deformed or stretched, or changes so much in the time, that it does not turn as one.
Mat3 turnedBack(const ElementLaw&, const Mat3& F, const Mat3& rate, double h);

/// Strain energy density, J/m³.
double energyDensity(const ElementLaw&, ConstitutiveLaw, const Mat3& F);

/// Largest principal Cauchy stress, Pa, times √(E/E_eff): what `fracture = "cell"` compares with
/// maxStress.
double largestPrincipalStress(const ElementLaw&, const Mat3& F, const Mat3& piola);

}  // namespace sunder::core
