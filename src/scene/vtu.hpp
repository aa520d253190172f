#pragma once
#include <string>

#include "core/world.hpp"

namespace sunder::scene {

/// The state as a VTK XML unstructured grid (.vtu, ASCII): tetrahedra at their current positions,
/// point data `displacement` and `velocity`, cell data `material`, `max_principal_stress`, `piece`.
std::string toVtu(const core::World&, const core::State&);

}  // namespace sunder::scene
