#pragma once
#include <limits>

#include "core/constants.hpp"
#include "core/types.hpp"

namespace sunder::core {

/// A material too stiff for the step is made softer, and so slower: cracks in it keep pace with its
/// waves, not with what hits it. A blow that adds a traction which strains it by this much, and
/// that in the material itself would be kSuddenStress times the strength, breaks a bond at once.
inline constexpr double kSuddenStrain = 0.5;

/// Constants of one material on cells of one size at the world's step: what an element needs to
/// turn strain into stress.
struct ElementLaw {
    int material = 0;
    Vec3 cellSize{1, 1, 1};
    double youngModulus = 0;    ///< Pa, E_eff: not more than the step can carry
    bool limited = false;       ///< E_eff < the material's
    double lambda = 0, mu = 0;  ///< Pa, Lamé parameters of E_eff
    double stressScale = 1;     ///< S = √(E/E_eff): what an impact's stress lost to the limit
    double damageTime = 1;      ///< s, τ = ℓ_d/√(E_eff/ρ)
    double maxStress = 0;       ///< Pa; infinite unless fracture = cell
    double suddenTraction = 0;  ///< Pa, kSuddenStrain·E_eff; infinite unless E is limited
    double restitution = 0;     ///< of the material, rounded to 1/255: what objects bounce with
    double contactDamping = 0;  ///< α of core/contact.hpp, from the material's restitution
    double hotViscosity = 0;    ///< Pa·s, of strongly deformed elements (core/elasticity.hpp)
    double largestStress = std::numeric_limits<double>::infinity();  ///< Pa, |P| by Green's law
};

/// Material constants of one cell come from a table of this many rows at most (one uniform block).
inline constexpr int kMaxElementLaws = 256;

}  // namespace sunder::core
