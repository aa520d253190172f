#include "view/panels/panels.hpp"

#include <imgui.h>

namespace sunder::view {
namespace {

void drawTabs(Session& session, Interface& ui, Drafts& drafts) {
    if (!ImGui::BeginTabBar("tabs")) return;
    session.measuring = false;
    const auto tab = [&](const char* label, const char* name, auto&& contents) {
        const bool open = ImGui::BeginTabItem(label);
        ui.mark(name);
        if (!open) return;
        // The tabs stay in sight while what is below them scrolls.
        ImGui::BeginChild("contents", {0, 0});
        contents();
        ImGui::Dummy({0, ui.length(8)});
        ImGui::EndChild();
        ImGui::EndTabItem();
    };
    tab("Play", "tab.play", [&] {
        drawHitTools(session, ui);
        drawViewChoices(session, ui, drafts.letters);
    });
    tab("Wall", "tab.wall", [&] { drawWall(session, ui, drafts.wall); });
    tab("Material", "tab.material", [&] { drawMaterial(session, ui, drafts.material); });
    tab("Measure", "tab.measure", [&] {
        session.measuring = true;
        drawMeasurements(session, ui);
    });
    ImGui::EndTabBar();
}

}  // namespace

float panelWidth(const Interface& ui) {
    return ui.length(340);
}

void drawPanels(Session& session, Interface& ui, Drafts& drafts) {
    if (session.settings.panel) {
        const ImGuiIO& io = ImGui::GetIO();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({panelWidth(ui), io.DisplaySize.y});
        ImGui::Begin("Sunder", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoBackground |  // see Interface::clear
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
        drawTime(session, ui);
        drawTabs(session, ui, drafts);
        ImGui::End();
    } else {
        session.measuring = false;
    }
    drawOverlays(session, ui);
    if (session.help) drawHelp(session, ui);
}

}  // namespace sunder::view
