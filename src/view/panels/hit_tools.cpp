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
    const auto slider = [&](const char* name, std::string_view key, double& value) {
        const core::Rule<Settings>& rule = *core::findRule(settingsRules(), key);
        ui.slider(name, value, {rule.range.min, rule.range.max}, rule.range.unit, rule.help);
    };
    if (settings.tool == Tool::Shoot)
        slider("strength", "shot", settings.shot);
    else
        slider("strength", "push", settings.push);
    ui.label("Radius");
    slider("radius", "radius", settings.radius);
    ImGui::TextDisabled("Keys 1 to 9 hit at nine places.");
    bool own = settings.sceneHits;
    if (ui.checkbox("scene_hits", "The scene's own hits", own,
                    "Starts again with the hits that the scene's file has, as `sunder run` does."))
        session.setSceneHits(own);
}

}  // namespace sunder::view
