#pragma once
#include "core/description.hpp"

namespace sunder::core {

/// Substeps in 1/60 s: contact carries what lies on it in proportion to them (core/contact.hpp).
inline constexpr int kFewestSubsteps = 50;

/// The fewest substeps in 1/60 s, from kFewestSubsteps on and a multiple of kLookSteps beyond, that
/// carry Young's modulus of every material that the bodies have, those that may come later
/// included (stableYoungModulus()); but no more than `most`.
int substepsFor(const WorldDescription& world, int most);

}  // namespace sunder::core
