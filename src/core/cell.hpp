#pragma once
#include <cstdint>

namespace sunder::core {

/// Corners of a cell: bit 0, 1, 2 of the corner's number is set on its +x, +y, +z side. Node =
/// 8·cell + corner.
inline constexpr int kCorners = 8;
inline constexpr int kTetrahedraPerCell = 5;
/// A cell owns the bonds through its +x, +y and +z faces. Bond = 3·cell + axis.
inline constexpr int kBondsPerCell = 3;
/// Damage of a bond that never was: no neighbour on that side. A bond holds while its damage is
/// below 1.
inline constexpr double kNoBond = 2;
/// Node indices and texel addresses stay exact in 32 bits up to here.
inline constexpr std::int64_t kMaxCells = 1 << 24;

}  // namespace sunder::core
