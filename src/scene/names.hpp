#pragma once
#include <string_view>

namespace sunder::scene {

// What scene files call the values of an enumeration, in its order.

constexpr std::string_view kSideNames[] = {"left", "right", "bottom", "top", "back", "front"};
constexpr std::string_view kShapeNames[] = {"sphere", "box", "capsule"};
/// EventDescription::Kind; then what happens to objects.
constexpr std::string_view kEventNames[] = {"impulse", "force", "velocity", "throw"};

}  // namespace sunder::scene
