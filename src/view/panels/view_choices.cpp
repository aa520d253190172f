#include <imgui.h>

#include <algorithm>

#include "sim_gl/solvers.hpp"
#include "view/panels/panels.hpp"

namespace sunder::view {
namespace {

void drawSolvers(Session& session, Interface& ui) {
    ui.heading("Solver");
    std::vector<std::string_view> names, titles;
    int current = 0;
    for (const sim::SolverInfo& solver : sim_gl::solvers()) {
        if (solver.name == session.stage->simulation.solverInfo().name)
            current = static_cast<int>(names.size());
        names.push_back(solver.name);
        titles.push_back(solver.title);
    }
    const int chosen = ui.choice("solver", names, current, titles);
    if (chosen >= 0) session.setSolver(std::string(names[chosen]));
}

template <class Value, std::size_t Count>
void drawChoice(Session& session, Interface& ui, const char* name, const char* label, Value& value,
                const Value (&values)[Count], const std::string_view (&labels)[Count],
                const std::string_view (&help)[Count]) {
    ui.label(label);
    const int current = static_cast<int>(std::find(values, values + Count, value) - values);
    const int chosen = ui.choice(name, labels, current, help);
    if (chosen < 0) return;
    value = values[chosen];
    session.changed(name, toString(value));
}

}  // namespace

void drawViewChoices(Session& session, Interface& ui, double& letters) {
    Settings& settings = session.settings;
    drawSolvers(session, ui);

    ui.heading("View");
    drawChoice(session, ui, "mesh", "Mesh", settings.mesh, render::kDrawnMeshes,
               {"Display", "Simulation"},
               {"What a player sees: torn edges, textures. M",
                "The hull of the tetrahedra that are simulated. M"});
    drawChoice(session, ui, "style", "Style", settings.style, render::kDrawStyles,
               {"Solid", "Wireframe", "Both"},
               {"Surfaces. L", "Edges of all triangles. L", "Surfaces with their edges. L"});
    drawChoice(
        session, ui, "colour", "Colours", settings.colour, render::kWallColours,
        {"Material", "Stress", "Speed", "Pieces"},
        {"As the material looks. C",
         "The largest tension in each cell; bright is the most that a material here bears. C",
         "How fast each cell moves. C",
         "What hangs together, each piece in a colour of its own. C"});
    ui.label("Samples", "Antialiasing: samples in each pixel. More: smoother edges, slower.");
    constexpr int kSamples[] = {1, 2, 4, 8};
    const int most = std::max(1, session.window.info().maxSamples);
    std::vector<std::string_view> labels{"Off"};
    for (const std::string_view label : {"2x", "4x", "8x"})
        if (kSamples[labels.size()] <= most) labels.push_back(label);
    int current = 0;
    while (current + 1 < static_cast<int>(labels.size()) && kSamples[current] < settings.samples)
        ++current;
    if (const int chosen = ui.choice("samples", labels, current); chosen >= 0)
        session.setSamples(kSamples[chosen]);

    ImGui::Dummy({0, ui.length(2)});
    bool vsync = settings.vsync, full = session.window.fullScreen();
    if (ui.checkbox("vsync", "Vertical sync", vsync, "Waits for the screen: no torn pictures."))
        session.setVsync(vsync);
    ImGui::SameLine();
    if (ui.checkbox("full_screen", "Full screen", full, "F11")) session.setFullScreen(full);
    if (ui.button("camera", "Reset camera", "Home")) session.lookHome();
    ImGui::SameLine();
    if (ui.button("picture", "Picture", "Saves what you see, without panels: P"))
        session.takePicture();
    ImGui::SameLine();
    if (ui.button("record", session.recording() ? "Stop video" : "Video",
                  "Records a video, 60 pictures a second however long each takes: V"))
        session.toggleRecording();

    // Letters grow when the mouse lets go, or the slider would run away under it.
    if (!ImGui::IsAnyItemActive()) letters = settings.interfaceScale;
    const core::Rule<Settings>& rule = *core::findRule(settingsRules(), "interface_scale");
    ui.label("Letters", rule.help);
    ui.slider("interface_scale", letters, {rule.range.min, rule.range.max}, "x", rule.help);
    if (ui.letGo()) settings.interfaceScale = letters;
}

}  // namespace sunder::view
