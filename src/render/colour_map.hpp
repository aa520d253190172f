#pragma once
#include <glm/glm.hpp>

namespace sunder::render {

/// From dark (0) to light (1) in steps that look equal, also to the colour-blind. Linear RGB; what
/// lies outside 0 to 1, or is no number, takes the nearer end, or 0.
glm::vec3 mapColour(double value);

/// A colour for each of many things, far from those of its neighbours in number. Linear RGB.
glm::vec3 distinctColour(int number);

/// Beside distinctColour()s, what is not to catch the eye. Linear RGB.
inline constexpr glm::vec3 kNeutralColour{0.42f, 0.42f, 0.42f};

}  // namespace sunder::render
