#pragma once
#include "view/interface.hpp"
#include "view/session.hpp"

namespace sunder::view {

/// Width of the panel at the window's left, pixels of the interface.
float panelWidth(const Interface&);

/// Everything on top of the scene: the panel with its tabs, messages, legend, help.
void drawPanels(Session&, Interface&);

// One file each.
void drawTime(Session&, Interface&);          ///< pause, step, speed; above the tabs
void drawHitTools(Session&, Interface&);      ///< tab "Play"
void drawViewChoices(Session&, Interface&);   ///< likewise
void drawWall(Session&, Interface&);          ///< tab "Wall": scene, size, cells, seed
void drawMaterial(Session&, Interface&);      ///< tab "Material"
void drawMeasurements(Session&, Interface&);  ///< tab "Measure"
void drawHelp(Session&, Interface&);          ///< over the scene
void drawOverlays(Session&, Interface&);      ///< likewise: hint, messages, legend, marks

}  // namespace sunder::view
