#include <imgui.h>

#include <string>
#include <utility>

#include "view/panels/panels.hpp"

namespace sunder::view {
namespace {

constexpr std::pair<const char*, const char*> kKeys[] = {
    {"", "Mouse"},
    {"Left button", "hit the wall; beside it, turn the camera"},
    {"Right button", "turn the camera"},
    {"Middle, or Shift + right", "move the camera"},
    {"Wheel", "nearer, further"},
    {"Shift + wheel", "strength of hits"},
    {"Ctrl + wheel", "radius of hits"},
    {"Ctrl or Alt + click", "stress of a cell; Esc: no longer"},
    {"Ctrl + click on a slider", "type a number"},
    {"Right click on a slider", "of a material: as it was"},
    {"A file dropped here", "opens the scene in it"},
    {"", "Hits"},
    {"1 ... 9", "hit at nine places, as on a keypad"},
    {"T", "next tool: shoot, push, pull, look"},
    {"", "Time"},
    {"Space", "pause, go on"},
    {"Full stop, comma", "one frame, one substep"},
    {"[  ]", "slower, faster"},
    {"R", "restart"},
    {"N", "a new wall: another seed"},
    {"", "View"},
    {"W A S D, Q E", "move ahead, sideways, down and up"},
    {"Arrows", "turn the camera"},
    {"Home", "camera as at first"},
    {"M", "display or simulation mesh"},
    {"L", "solid, wireframe, both"},
    {"C", "colours: material, stress, speed, pieces"},
    {"G", "next solver"},
    {"F11", "full screen"},
    {"Tab", "panel on, off"},
    {"", "Pictures"},
    {"P, F12", "save a picture"},
    {"V", "start, stop a video"},
    {"", ""},
    {"F1, H", "this list"},
    {"Ctrl + Q", "quit"},
};

}  // namespace

void drawHelp(Session& session, Interface& ui) {
    const float d = ui.density();
    const ViewArea& area = session.area;
    const ImVec2 centre((static_cast<float>(area.left) + static_cast<float>(area.width) / 2) / d,
                        (static_cast<float>(area.top) + static_cast<float>(area.height) / 2) / d);
    ImGui::SetNextWindowPos(centre, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {ui.length(560), ImGui::GetIO().DisplaySize.y});
    ImGui::SetNextWindowBgAlpha(0.94f);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.length(8), ui.length(1)});
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ui.length(6), 0});
    if (ImGui::Begin("Keys and mouse", &session.help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove)) {
        if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (const auto& [key, what] : kKeys) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                if (*key) {
                    ImGui::TextUnformatted(key);
                    ImGui::TableNextColumn();
                    ImGui::TextDisabled("%s", what);
                } else {
                    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", what);
                }
            }
            ImGui::EndTable();
        }
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace sunder::view
