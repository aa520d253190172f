#pragma once
#include <array>
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

/// Stress of a cell's four corner tetrahedra in the material frame, T = sym(RᵀP), Pa. The one whose
/// apex is corner a has number a/2.
using CornerStresses = std::array<Mat3, 4>;

/// Equivalent traction, Pa, on the face between a cell and its neighbour along `axis` (0..2), from
/// the stresses on either side: what `fracture = "bond"` compares with a strength, before what is
/// dynamic in it is scaled by S. The difference of the normal tractions of the face's two triangles
/// catches bending.
double equivalentTraction(const World&, int cell, int axis, const CornerStresses& own,
                          const CornerStresses& neighbours);

/// What a body that is at rest with the state's displacements bears becomes the slow part of its
/// stresses: State::slow of the bonds that a traction breaks, and State::slowStress.
void makeStressesSlow(const World&, int body, State&);

/// Share of what is new in a stress that its slow part takes up from one fracture update to the
/// next: its time is a tenth of a second.
double slowShare(const World&);

}  // namespace sunder::core
