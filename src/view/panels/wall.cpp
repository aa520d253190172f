#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "core/rules.hpp"
#include "view/panels/panels.hpp"

namespace sunder::view {

using namespace core;

namespace {

void take(WallDraft& draft, const scene::Scene& scene, int body) {
    const BodyDescription& from = scene.world.bodies[body];
    draft.body = body;
    draft.size = from.size;
    draft.cells = from.cells;
    draft.seed = scene.world.seed;
}

/// Regions keep their share of the body.
void resize(BodyDescription& body, const Vec3& size, const IVec3& cells) {
    for (RegionDescription& region : body.regions)
        for (int axis = 0; axis < 3; ++axis) {
            const auto scaled = [&](int cell) {
                const std::int64_t wanted = std::int64_t{cell} * cells[axis] / body.cells[axis];
                return static_cast<int>(std::min<std::int64_t>(wanted, cells[axis] - 1));
            };
            region.from[axis] = scaled(region.from[axis]);
            region.to[axis] = std::max(scaled(region.to[axis]), region.from[axis]);
        }
    body.size = size;
    body.cells = cells;
}

void drawScenes(Session& session, Interface& ui, std::string& path) {
    ui.heading("Scene");
    ImGui::SetNextItemWidth(-1);
    const bool open =
        ImGui::BeginCombo("###scene", session.scene().name.c_str(), ImGuiComboFlags_HeightLargest);
    ui.mark("scene");
    if (open) {
        static const std::vector<scene::PresetInfo> scenes = scene::scenePresets();
        std::string chosen;
        for (const scene::PresetInfo& scene : scenes) {
            if (ImGui::Selectable(scene.name.c_str(), scene.name == session.scene().name))
                chosen = scene.name;
            ui.mark("scene." + scene.name);
            ui.tooltip(scene.title);
        }
        ImGui::EndCombo();
        if (!chosen.empty()) session.openScene(chosen);
    }
    ImGui::TextWrapped("%s", session.scene().title.c_str());

    ImGui::SetNextItemWidth(-ui.length(70));
    bool wanted = ImGui::InputTextWithHint("###scene_file", "a scene's file, .toml", &path,
                                           ImGuiInputTextFlags_EnterReturnsTrue);
    ui.mark("scene_file");
    ImGui::SameLine();
    wanted |= ui.button("open", "Open", "Reads a scene of your own. Or drop its file here.");
    if (wanted) session.openScene(path);
}

void drawBodies(WallDraft& draft, const scene::Scene& scene, Interface& ui) {
    const auto& bodies = scene.world.bodies;
    if (bodies.size() < 2) return;
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("###body", bodies[draft.body].name.c_str())) return;
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i)
        if (ImGui::Selectable((bodies[i].name + "##" + std::to_string(i)).c_str(), i == draft.body))
            take(draft, scene, i);
    ImGui::EndCombo();
    ui.tooltip("Which of the scene's bodies");
}

}  // namespace

void drawWall(Session& session, Interface& ui, WallDraft& draft) {
    drawScenes(session, ui, draft.fileToOpen);

    const scene::Scene& scene = session.scene();
    if (std::exchange(draft.layout, session.layout()) != session.layout())
        take(draft, scene, std::min(draft.body, static_cast<int>(scene.world.bodies.size()) - 1));
    ui.heading("A new wall");
    drawBodies(draft, scene, ui);
    const Range& sizes = findRule(bodyRules(), "size")->range;
    ImGui::TextUnformatted("Size: wide, high, thick (m)");
    ImGui::SetNextItemWidth(-1);
    ImGui::DragScalarN("###size", ImGuiDataType_Double, draft.size.data(), 3, 0.02f, &sizes.min,
                       &sizes.max, "%.3g m", ImGuiSliderFlags_AlwaysClamp);
    ui.mark("size");
    ui.tooltip("Drag, or Ctrl and click to type.");
    const Range& counts = findRule(bodyRules(), "cells")->range;
    const int fewest = static_cast<int>(counts.min), cellsMost = static_cast<int>(counts.max);
    ImGui::TextUnformatted("Cells: wide, high, thick");
    ImGui::SetNextItemWidth(-1);
    ImGui::DragScalarN("###cells", ImGuiDataType_S32, draft.cells.data(), 3, 0.2f, &fewest,
                       &cellsMost, "%d", ImGuiSliderFlags_AlwaysClamp);
    ui.mark("cells");
    ui.tooltip("Five tetrahedra each. More: finer pieces, slower. About cubic is best.");
    ImGui::TextUnformatted("Seed");
    ImGui::SetNextItemWidth(-1);
    ImGui::InputScalar("###seed", ImGuiDataType_U64, &draft.seed);
    ui.mark("seed");
    ui.tooltip("Another number is another wall of the same kind: it breaks elsewhere.");
    const Vec3 cell = draft.size.cwiseQuotient(draft.cells.cast<double>());
    ImGui::TextDisabled("%.3g x %.3g x %.3g m a cell, %.0f tetrahedra", cell[0], cell[1], cell[2],
                        kTetrahedraPerCell * draft.cells.cast<double>().prod());
    if (ui.button("build", "Build", "Builds the wall anew.")) {
        scene::Scene next = scene;
        resize(next.world.bodies[draft.body], draft.size, draft.cells);
        next.world.seed = draft.seed & 0x7fffffffffffffffu;
        session.buildScene(std::move(next), "build");
    }
    ImGui::SameLine();
    if (ui.button("new_seed", "Another seed", "N")) session.newSeed();
    ImGui::SameLine();
    if (ui.button("revert_scene", "Revert", "The scene as it was opened."))
        session.buildScene(session.openedScene(), "revert_scene");

    ui.heading("Save as");
    ImGui::SetNextItemWidth(-ui.length(70));
    bool save =
        ImGui::InputText("###scene_name", &draft.fileToSave, ImGuiInputTextFlags_EnterReturnsTrue);
    ui.mark("scene_name");
    ImGui::SameLine();
    save |= ui.button("save_scene", "Save",
                      "Scene, materials and camera in one file, which `sunder run` reads.");
    if (save) session.saveScene(draft.fileToSave);
}

}  // namespace sunder::view
