#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/diagnostics.hpp"
#include "core/limit_notes.hpp"
#include "core/loss_notes.hpp"
#include "view/panels/panels.hpp"

namespace sunder::view {

using namespace core;

namespace {

void drawPlot(Interface& ui, const char* label, const History& history) {
    char now[96];
    std::snprintf(now, sizeof now, "%s: %.2f ms", label, history.mean(30));
    // The scale starts at a frame of 60 a second, so that quick passes look quick.
    const float top = static_cast<float>(std::max(history.largest(), 1000.0 / 60));
    ImGui::PlotLines((std::string("###plot.") + label).c_str(), history.values(), History::kLength,
                     history.next(), now, 0, top,
                     {ImGui::GetContentRegionAvail().x, ui.length(34)});
    ui.mark(std::string("plot.") + label);
}

void drawTable(std::initializer_list<std::pair<const char*, std::string>> rows) {
    if (!ImGui::BeginTable("numbers", 2, ImGuiTableFlags_SizingStretchProp)) return;
    for (const auto& [label, value] : rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", label);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(value.c_str());
    }
    ImGui::EndTable();
}

void drawCell(Session& session, int cell) {
    const World& world = session.stage->simulation.world();
    const State& state = session.stage->simulation.state();
    const Body& body = world.bodies()[world.bodyOf(cell)];
    const IVec3 at = body.coordinates(cell);
    const Material& material = world.materialOf(cell);
    Vec3 velocity(0, 0, 0);
    for (int corner = 0; corner < kCorners; ++corner)
        velocity += state.velocity[kCorners * cell + corner] / kCorners;
    int held = 0, broken = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) {
            const int neighbour = world.neighbour(cell, axis, side);
            if (neighbour < 0 || !world.present(neighbour)) continue;
            const int owner = side > 0 ? cell : neighbour;
            ++(state.damage[kBondsPerCell * owner + axis] < 1 ? held : broken);
        }
    char place[64];
    std::snprintf(place, sizeof place, "%d, %d, %d of %s", at[0], at[1], at[2], body.name.c_str());
    drawTable({{"Cell", place},
               {"Material", material.name},
               {"Stress now", brief(cellPrincipalStress(world, state, cell), "Pa")},
               {"Breaks at", breaksAt(material)},
               {"Speed", brief(velocity.norm(), "m/s")},
               {"Bonds", std::to_string(held) + " hold, " + std::to_string(broken) + " broken"}});
}

}  // namespace

std::string brief(double value, const char* unit) {
    char text[48];
    const double size = std::abs(value);
    const char* prefix = size >= 1e9 ? "G" : size >= 1e6 ? "M" : size >= 1e4 ? "k" : "";
    const double scale = size >= 1e9 ? 1e9 : size >= 1e6 ? 1e6 : size >= 1e4 ? 1e3 : 1;
    std::snprintf(text, sizeof text, "%.4g %s%s", value / scale, prefix, unit);
    return text;
}

std::string breaksAt(const Material& material) {
    switch (material.fracture) {
        case FractureMode::None:
            break;
        case FractureMode::Cell:
            return brief(material.maxStress, "Pa");
        case FractureMode::Bond:
            return brief(material.strength.minCoeff(), "Pa") + " or more";
    }
    return "never";
}

void drawMeasurements(Session& session, Interface& ui) {
    const Measurements& m = session.measurements;
    const World& world = session.stage->simulation.world();
    ui.heading("The wall");
    drawTable({{"Tetrahedra", std::to_string(kTetrahedraPerCell * world.presentCells())},
               {"Pieces", std::to_string(m.diagnostics.pieces)},
               {"Bonds broken", std::to_string(m.diagnostics.bondsBroken) + " of " +
                                    std::to_string(world.bondCount())},
               {"Blows heard", std::to_string(m.contacts)},
               {"Energy of motion", brief(m.diagnostics.kinetic, "J")},
               {"Energy of bending", brief(m.diagnostics.elastic, "J")},
               {"Energy of height", brief(m.diagnostics.gravity, "J")},
               {"Fastest", brief(m.diagnostics.maxSpeed, "m/s")}});
    for (const std::string& note : core::limitNotes(world)) ImGui::TextWrapped("%s", note.c_str());
    for (const std::string& note : lossNotes(world, session.stage->simulation.solver()))
        ImGui::TextWrapped("%s", note.c_str());

    ui.heading("One cell");
    if (session.lookedAt)
        drawCell(session, *session.lookedAt);
    else
        ImGui::TextWrapped(
            "Click a cell with the tool Look, or with Ctrl held, to read its stress.");

    ui.heading("Time per frame");
    ImGui::TextDisabled("%.0f frames/s; the last %d frames", m.framesPerSecond(), History::kLength);
    drawPlot(ui, "frame", m.frame);
    drawPlot(ui, "simulation", m.simulation);
    drawPlot(ui, "drawing", m.drawing);
    drawPlot(ui, "interface", m.interface);
    if (!m.passes.empty()) ui.heading("Passes");
    for (const auto& [name, history] : m.passes) drawPlot(ui, name.c_str(), history);
    ImGui::TextDisabled("%s", session.window.info().renderer.c_str());
}

}  // namespace sunder::view
