#pragma once
#include <array>

namespace sunder::core {

/// Corners of one tetrahedron, positively oriented: det(x₁−x₀, x₂−x₀, x₃−x₀) > 0 at rest. Corner
/// tetrahedra start with their apex, the corner where three edges of the cell meet.
using Tetrahedron = std::array<int, 4>;

/// A cell's five tetrahedra (thesis, figure 6.2), by the parity of i+j+k: neighbours are mirrored,
/// so their face diagonals agree. Numbers 0–3 are the corner tetrahedra (1/6 of the volume each),
/// number 4 the central one (1/3).
inline constexpr std::array<std::array<Tetrahedron, 5>, 2> kTetrahedra = {{
    {{{1, 0, 5, 3}, {2, 3, 6, 0}, {4, 5, 0, 6}, {7, 6, 3, 5}, {0, 5, 3, 6}}},
    {{{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}}},
}};

}  // namespace sunder::core
