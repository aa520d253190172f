#pragma once
#include <cstddef>

namespace sunder::core {

// How much of everything a world may have. Far beyond any sensible one; there so that a broken or
// hostile description ends in a sentence and not in minutes of work or gigabytes of memory.
// Cells: kMaxCells (core/cell.hpp). Objects: kMaxObjects (core/object.hpp). Combinations of
// material and cell size: kMaxElementLaws (core/element_law.hpp).
inline constexpr std::size_t kMaxName = 64;           ///< characters of a body's or object's name
inline constexpr std::size_t kMaxDescription = 1000;  ///< characters of a material's description
inline constexpr std::size_t kMaxReference = 1000;    ///< characters of a material's name or path
inline constexpr std::size_t kMaxBodies = 10000;
inline constexpr std::size_t kMaxRegions = 256;   ///< of one body
inline constexpr std::size_t kMaxEvents = 10000;  ///< as many throws besides
inline constexpr double kMaxLength = 1e4;         ///< m, any coordinate
inline constexpr double kMaxTime = 1e5;           ///< s
inline constexpr double kMaxStep = 0.1;           ///< s, of a substep

}  // namespace sunder::core
