#include <imgui.h>

#include "view/panels/panels.hpp"

namespace sunder::view {

void drawHitTools(Session& session, Interface& ui) {
    Settings& settings = session.settings;
    ui.heading("Mouse on the wall");
    constexpr std::string_view kLabels[] = {"Shoot", "Push", "Pull", "Look"};
    constexpr std::string_view kHelp[] = {
        "A blow where you click, one after the other while you drag.",
        "Presses as long as you hold the button.", "Draws it towards you.",
        "Shows the stress in the cell that you click."};
    const int chosen = ui.choice("tool", kLabels, static_cast<int>(settings.tool), kHelp);
    if (chosen >= 0) {
        settings.tool = kTools[chosen];
        session.changed("tool", toString(settings.tool));
    }
    ui.label("Strength");
    if (settings.tool == Tool::Shoot)
        ui.slider("strength", settings.shot, {1, 150}, "m/s",
                  "Speed that the middle of the spot gets. Shift and wheel.");
    else
        ui.slider("strength", settings.push, {1, 2000}, "m/s²",
                  "Acceleration of the middle of the spot while you hold the button. Shift and "
                  "wheel.");
    ui.label("Radius");
    ui.slider("radius", settings.radius, {0.02, 2}, "m",
              "Size of the spot: the ring around the mouse. Ctrl and wheel.");
    ImGui::TextDisabled("Keys 1 to 9 hit at nine places.");
    bool own = settings.sceneHits;
    if (ui.checkbox("scene_hits", "The scene's own hits", own,
                    "Starts again with the hits that the scene's file has, as `sunder run` does."))
        session.setSceneHits(own);
}

}  // namespace sunder::view
