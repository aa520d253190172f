#pragma once
#include <cstddef>

namespace sunder::scene {

/// What a file may ask for. Far beyond any sensible scene; there so that a broken or hostile file
/// ends in a sentence and not in minutes of work or gigabytes of memory.
inline constexpr std::size_t kMaxName = 64;           ///< characters of a body's or material's name
inline constexpr std::size_t kMaxTitle = 200;         ///< characters
inline constexpr std::size_t kMaxDescription = 1000;  ///< characters
inline constexpr std::size_t kMaxReference = 1000;    ///< characters of a material's name or path
inline constexpr std::size_t kMaxMaterials = 256;
inline constexpr std::size_t kMaxBodies = 10000;  ///< copies included
inline constexpr std::size_t kMaxRegions = 256;   ///< of one body
inline constexpr std::size_t kMaxEvents = 10000;  ///< one per copy it acts on
inline constexpr double kMaxLength = 1e4;         ///< m, any coordinate
inline constexpr double kMaxTime = 1e5;           ///< s

}  // namespace sunder::scene
