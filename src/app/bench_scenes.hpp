#pragma once
#include <string>

#include "scene/scene.hpp"

namespace sunder::app {

/// All events earlier by as much as lets the first begin at once.
Scene hitAtOnce(Scene);

/// `walls` copies of the scene's first body in a grid, each with that body's events.
Scene withWalls(Scene, int walls);

/// One step per frame, fracture tested on every one: what the thesis did.
Scene oneStepPerFrame(Scene);

/// One wall of the wood preset, one or two cells thick, hit at time 0. `tetrahedra` must be one of
/// scalingSizes().
Scene scalingScene(int tetrahedra);
const std::vector<int>& scalingSizes();  ///< 2,000 to 2,000,000

}  // namespace sunder::app
