#pragma once
#include <string_view>

namespace sunder::core {

// What files and messages call the values of an enumeration, in its order.

inline constexpr std::string_view kSideNames[] = {"left", "right", "bottom",
                                                  "top",  "back",  "front"};
inline constexpr std::string_view kShapeNames[] = {"sphere", "box", "capsule"};
/// EventDescription::Kind; then what happens to every body, and to objects.
inline constexpr std::string_view kEventNames[] = {"impulse", "force", "velocity", "blast",
                                                   "throw"};
inline constexpr std::string_view kLawNames[] = {"green", "corotated"};
inline constexpr std::string_view kFractureNames[] = {"none", "cell", "bond"};
inline constexpr std::string_view kClusterNames[] = {"none", "voronoi", "running-bond", "planks"};
inline constexpr std::string_view kSurfaceNames[] = {"plain",    "wood",   "brick",
                                                     "concrete", "rubber", "glass"};

}  // namespace sunder::core
