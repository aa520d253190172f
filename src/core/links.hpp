#pragma once
#include <cstdint>

#include "core/world.hpp"

namespace sunder::core {

/// The at most eight cells around a lattice point are its octants: bits 0, 1, 2 of an octant's
/// number are set on the +x, +y, +z side. In octant o the point is the cell's corner o^7.
///
/// Twelve bonds join them: bond 4·axis + n, n = 0..3, joins the n-th octant (in ascending order)
/// whose bit `axis` is clear with the octant that has it set.

/// The octant at the lower end of bond 0..11.
constexpr int bondOctant(int bond) {
    const int axis = bond / 4, n = bond % 4;
    const int low = n & ((1 << axis) - 1);
    return low | ((n & ~((1 << axis) - 1)) << 1);
}

/// Octants that hang together with `octant`, as eight bits, when the bonds in `held` (twelve bits)
/// hold: a plain flood fill.
std::uint8_t linkMask(unsigned held, int octant);

/// linkMask() of a corner of a cell that is joined to all cells its body has room for around it.
std::uint8_t wholeMask(const World&, int cell, int corner);

/// World-wide cell in `octant` around the lattice point at corner `corner` of `cell`, or −1 outside
/// the body.
int cellInOctant(const World&, int cell, int corner, int octant);

/// The twelve bonds around the lattice point at corner `corner` of `cell`: bit set while the bond
/// holds.
unsigned heldBonds(const World&, const State&, int cell, int corner);

}  // namespace sunder::core
