#include <imgui.h>

#include "view/panels/panels.hpp"

namespace sunder::view {

void drawTime(Session& session, Interface& ui) {
    Clock& clock = session.clock;
    const int frame = session.stage->simulation.stepsPerFrame();
    if (ui.button("pause", clock.paused() ? "Play" : "Pause", "Space"))
        session.setPaused(!clock.paused());
    ImGui::SameLine();
    if (ui.button("step", "Step", "One frame, 1/60 s: full stop key. One substep: comma."))
        session.stepOnce(frame);
    ImGui::SameLine();
    if (ui.button("restart", "Restart", "The same wall from its start: R")) session.restart();
    ImGui::SameLine();
    if (ui.button("help", "Keys", "All keys: F1")) session.help = !session.help;

    double speed = clock.speed();
    ui.label("Speed");
    if (ui.slider("speed", speed, {Clock::kSlowest, 1}, "x",
                  "1: as fast as time outside. Less: slow motion. Keys [ and ]"))
        session.setSpeed(speed);

    const double seconds = session.stage->simulation.time();
    if (clock.paused()) {
        ImGui::Text("%.3f s, paused", seconds);
    } else if (session.recording()) {
        ImGui::Text("%.3f s, recording: 60 pictures a second", seconds);
    } else if (clock.behind()) {
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark),
                           "%.3f s, machine too slow: %.0f %% of speed", seconds,
                           100 * clock.share());
        ui.tooltip(
            "It cannot simulate and draw this as fast as time passes, so time is left out. "
            "Another solver, fewer cells or less antialiasing may help.");
    } else {
        ImGui::Text("%.3f s, %.0f frames/s", seconds, session.measurements.framesPerSecond());
    }
    ImGui::Dummy({0, ui.length(2)});
}

}  // namespace sunder::view
