#pragma once
#include "core/object_contact.hpp"

namespace sunder::core {

/// m: negative where two rounded boxes are in each other, and then how far one must at least be
/// moved until they are not: exact, whether their cores meet or not (touchOf(), which is made for
/// every step, knows no depth beyond the radii). Positive: they are at least that far apart.
double gapBetween(const RoundedBox& a, const RoundedBox& b);

}  // namespace sunder::core
