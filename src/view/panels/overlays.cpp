#include <imgui.h>

#include <array>
#include <cmath>

#include "core/diagnostics.hpp"
#include "image/srgb.hpp"
#include "render/colour_map.hpp"
#include "render/legend.hpp"
#include "view/panels/panels.hpp"

namespace sunder::view {

using namespace core;

namespace {

ImU32 shown(const glm::vec3& linear) {
    return IM_COL32(image::srgbByte(linear.r), image::srgbByte(linear.g), image::srgbByte(linear.b),
                    255);
}

/// Where a place of the world is, in the interface's pixels, and its depth, m.
Vec3 onScreen(const Session& session, const Interface& ui, const Vec3& place) {
    const ViewArea& area = session.area;
    const Vec3 p = session.camera.project(place, area.aspect());
    return {(area.left + (p[0] + 1) / 2 * area.width) / ui.density(),
            (area.top + (1 - p[1]) / 2 * area.height) / ui.density(), p[2]};
}

ImVec2 toImGui(const Vec3& p) {
    return {static_cast<float>(p[0]), static_cast<float>(p[1])};
}

/// Around the mouse: how much of the wall a hit takes.
void drawRing(const Session& session, const Interface& ui, ImDrawList& list) {
    if (!session.hovered || session.settings.tool == Tool::Look) return;
    const Vec3 centre = onScreen(session, ui, session.hovered->place);
    const double tangent =
        std::tan(session.camera.description().fieldOfView * 3.14159265358979 / 360);
    const double radius =
        session.settings.radius / (2 * tangent * centre[2]) * session.area.height / ui.density();
    const auto pixels = static_cast<float>(radius);
    list.AddCircle(toImGui(centre), pixels, IM_COL32(20, 20, 20, 120), 64, ui.length(3));
    list.AddCircle(toImGui(centre), pixels, IM_COL32(255, 240, 220, 200), 64, ui.length(1.25));
}

void drawText(const Interface& ui, ImDrawList& list, ImVec2 at, const char* text) {
    const float pad = ui.length(6);
    const ImVec2 size = ImGui::CalcTextSize(text);
    list.AddRectFilled({at.x - pad, at.y - pad / 2}, {at.x + size.x + pad, at.y + size.y + pad / 2},
                       IM_COL32(20, 21, 25, 190), ui.length(4));
    list.AddText(at, IM_COL32(240, 240, 235, 255), text);
}

/// Edges of the cell whose stress is read, and the stress.
void drawLookedAt(Session& session, const Interface& ui, ImDrawList& list) {
    if (!session.lookedAt) return;
    const World& world = session.stage->simulation.world();
    const State& state = session.stage->simulation.state();
    std::array<Vec3, kCorners> corners;
    for (int corner = 0; corner < kCorners; ++corner) {
        const int node = kCorners * *session.lookedAt + corner;
        corners[corner] =
            onScreen(session, ui, world.restPosition(node) + state.displacement[node]);
        if (corners[corner][2] <= 0) return;
    }
    for (int corner = 0; corner < kCorners; ++corner)
        for (const int axis : {1, 2, 4})
            if (!(corner & axis))
                list.AddLine(toImGui(corners[corner]), toImGui(corners[corner | axis]),
                             IM_COL32(255, 200, 60, 255), ui.length(1.5));
    const int cell = *session.lookedAt;
    const std::string stress = brief(cellPrincipalStress(world, state, cell), "Pa") +
                               ", breaks at " + breaksAt(world.materialOf(cell));
    Vec3 right = corners[0];
    for (const Vec3& corner : corners)
        if (corner[0] > right[0]) right = corner;
    const ImVec2 at = toImGui(right);
    drawText(ui, list, {at.x + ui.length(14), at.y}, stress.c_str());
}

/// In the lower right corner of the scene.
void drawLegend(Session& session, Interface& ui, ImDrawList& list) {
    if (session.settings.colour == render::WallColour::Material) return;
    const render::ColourKey& key = session.stage->colours.key();
    const float d = ui.density(), margin = ui.length(16), line = ImGui::GetTextLineHeight();
    const float right = static_cast<float>(session.area.left + session.area.width) / d - margin;
    const float bottom = static_cast<float>(session.area.top + session.area.height) / d - margin;
    if (const std::string text = render::legendText(key); !text.empty()) {
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        drawText(ui, list, {right - width, bottom - line}, text.c_str());
        return;
    }
    const float width = ui.length(230);
    const bool fits = static_cast<float>(session.area.width) / d > width + 2 * margin;
    if (!render::hasScale(key) || !fits) return;
    const float bar = ui.length(14), gap = ui.length(4);
    const float left = right - width, top = bottom - 2 * line - bar - 2 * gap;
    list.AddRectFilled({left - gap * 2, top - gap}, {right + gap * 2, bottom + gap},
                       IM_COL32(20, 21, 25, 190), ui.length(4));
    list.AddText({left, top}, IM_COL32(240, 240, 235, 255), render::legendTitle(key).c_str());
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i)
        list.AddRectFilled(
            {left + width * static_cast<float>(i) / kSteps, top + line + gap},
            {left + width * static_cast<float>(i + 1) / kSteps, top + line + gap + bar},
            shown(render::mapColour((i + 0.5) / kSteps)));
    const std::array<std::string, 3> numbers = render::legendNumbers(key);
    for (int i = 0; i < 3; ++i) {
        const float own = ImGui::CalcTextSize(numbers[i].c_str()).x;
        list.AddText({left + (width - own) * static_cast<float>(i) / 2, bottom - line},
                     IM_COL32(240, 240, 235, 255), numbers[i].c_str());
    }
}

void drawMessages(const Session& session, const Interface& ui) {
    const float d = ui.density(), margin = ui.length(14);
    const float left = static_cast<float>(session.area.left) / d + margin;
    const float width = static_cast<float>(session.area.width) / d - 2 * margin;
    float top = margin;
    const auto box = [&](const char* name, const std::string& text, bool problem) {
        ImGui::SetNextWindowPos({left, top});
        ImGui::SetNextWindowSizeConstraints({0, 0}, {width, ImGui::GetIO().DisplaySize.y / 2});
        ImGui::PushStyleColor(ImGuiCol_WindowBg, problem ? ImVec4(0.36f, 0.09f, 0.07f, 0.94f)
                                                         : ImVec4(0.09f, 0.1f, 0.115f, 0.86f));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.length(4));
        ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
        ImGui::PushTextWrapPos(width - margin);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopTextWrapPos();
        top += ImGui::GetWindowHeight() + ui.length(6);
        ImGui::End();
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
    };
    if (!session.shaderError().empty())
        box("shader error",
            "A shader does not compile; those from before go on.\n" + session.shaderError(), true);
    int number = 0;
    for (const Session::Message& message : session.messages())
        box(("message " + std::to_string(number++)).c_str(), message.text, message.problem);
}

void drawHint(const Session& session, const Interface& ui, ImDrawList& list) {
    if (session.everHit || session.help) return;
    const char* text = "Click the wall to hit it.  Right button turns the camera.  F1: all keys.";
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float d = ui.density();
    const ViewArea& area = session.area;
    drawText(ui, list,
             {(static_cast<float>(area.left) + static_cast<float>(area.width) / 2) / d - size.x / 2,
              static_cast<float>(area.top + area.height) / d - size.y - ui.length(22)},
             text);
}

}  // namespace

void drawOverlays(Session& session, Interface& ui) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    drawRing(session, ui, list);
    drawLookedAt(session, ui, list);
    drawLegend(session, ui, list);
    drawHint(session, ui, list);
    drawMessages(session, ui);
    if (session.recording()) {
        const float left =
            static_cast<float>(session.area.left + session.area.width) / ui.density();
        drawText(ui, list, {left - ui.length(60), ui.length(16)}, "REC");
    }
}

}  // namespace sunder::view
