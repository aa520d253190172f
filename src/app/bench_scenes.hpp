#pragma once
#include <string>

#include "scene/scene.hpp"

namespace sunder::app {

/// All events earlier by as much as lets the first begin at once.
scene::Scene hitAtOnce(scene::Scene);

/// `walls` copies of the scene's first body in a grid, each with that body's events.
scene::Scene withWalls(scene::Scene, int walls);

/// One step per frame, fracture tested on every one: what the thesis did.
scene::Scene oneStepPerFrame(scene::Scene);

/// Without its own events, and with so many explosions at once, one after the other at the middles
/// of its bodies. They last, and are too weak to break anything: what differs is what they cost.
/// So is a push of each body, which keeps all of them awake, explosions or not.
scene::Scene withExplosions(scene::Scene, int count);

/// One wall of the wood preset, one or two cells thick, hit at time 0. `tetrahedra` must be one of
/// scalingSizes().
scene::Scene scalingScene(int tetrahedra);
const std::vector<int>& scalingSizes();  ///< 2,000 to 2,000,000

}  // namespace sunder::app
