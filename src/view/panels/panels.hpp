#pragma once
#include "view/interface.hpp"
#include "view/session.hpp"

namespace sunder::view {

/// Width of the panel at the window's left, pixels of the interface.
float panelWidth(const Interface&);

/// What the fields of the tab "Wall" hold until their button is pressed.
struct WallDraft {
    int layout = -1;  ///< of the session, that it was taken from
    int body = 0;
    core::Vec3 size{1, 1, 1};  ///< m
    core::IVec3 cells{1, 1, 1};
    std::uint64_t seed = 1;
    std::string fileToOpen, fileToSave = "my-wall";
};

/// The material on the sliders, which may be ahead of the one that is simulated.
struct MaterialDraft {
    int generation = -1, layout = -1;  ///< of the session, that it was taken from
    int index = 0;                     ///< among the scene's materials
    core::Material material;
    core::Material home;  ///< as it was before it was tuned
    double age = 0;       ///< s since it was last simulated
    std::string fileToSave = "my-material";
};

/// What was entered and not done yet.
struct Drafts {
    WallDraft wall;
    MaterialDraft material;
    double letters = 1;  ///< their size on the slider
};

/// Everything on top of the scene: the panel with its tabs, messages, legend, help.
void drawPanels(Session&, Interface&, Drafts&);

/// A number of 1 to 10,000 with its unit, in thousands, millions or thousands of millions.
std::string brief(double value, const char* unit);
/// The stress at which a material breaks, in words.
std::string breaksAt(const core::Material&);

// One file each.
void drawTime(Session&, Interface&);      ///< pause, step, speed; above the tabs
void drawHitTools(Session&, Interface&);  ///< tab "Play"
void drawViewChoices(Session&, Interface&, double& letters);  ///< likewise
void drawWall(Session&, Interface&, WallDraft&);          ///< tab "Wall": scene, size, cells, seed
void drawMaterial(Session&, Interface&, MaterialDraft&);  ///< tab "Material"
void drawMeasurements(Session&, Interface&);              ///< tab "Measure"
void drawHelp(Session&, Interface&);                      ///< over the scene
void drawOverlays(Session&, Interface&);  ///< likewise: hint, messages, legend, marks

}  // namespace sunder::view
