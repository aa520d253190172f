#include "view/viewer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "core/loss_notes.hpp"
#include "files/held_signals.hpp"
#include "gpu/pass_timer.hpp"
#include "sim_gl/solvers.hpp"
#include "view/controls.hpp"
#include "view/every.hpp"
#include "view/panels/panels.hpp"

namespace sunder::view {

using namespace core;

namespace {

class Viewer {
  public:
    Viewer(window::Window& window, const Options& options, const Settings& settings)
        : window_(window), session_(window, options, settings), interface_(window) {}

    /// Returns the signal that ended it, or 0.
    int run() {
        files::HeldSignals held;
        session_.clock.skip();  // windows take their time to open
        try {
            goOn();
        } catch (...) {
            remember();
            throw;
        }
        const std::string recording = remember();
        session_.stage.reset();
        session_.log.add("closed", {{"frames", frames_}, {"gl_bytes_left", gl::allocatedBytes()}});
        const int signal = files::notedSignal();
        if (signal)
            std::cerr << "sunder: interrupted" << (recording.empty() ? recording : ": " + recording)
                      << '\n';
        held.answer();
        return signal;
    }
    void sayProblem(const std::string& text) { session_.say(text, true); }

  private:
    void goOn() {
        auto last = Instant::now();
        while (!window_.closing() && !files::notedSignal()) {
            // Where nothing moves, a frame waits for what the user does. A video need not.
            constexpr double kFrame = 1.0 / 60;
            const bool still = session_.clock.paused() || (still_ && !session_.recording());
            window_.poll(still ? std::max(0.0, kFrame - secondsSince(last)) : 0);
            const auto now = Instant::now();
            const double elapsed = seconds(now - std::exchange(last, now));
            // Nobody sees it; time stands still, too.
            if (window_.minimised()) {
                letGo();
                session_.clock.skip();
                logStatus();
                continue;
            }
            if (!frame(elapsed)) break;
        }
    }

    bool frame(double elapsed) {
        const auto start = Instant::now();
        session_.log.beginFrame(frames_);
        for (const std::string& path : window_.input().dropped) session_.openScene(path);
        controls_.begin(elapsed);
        if (!replay()) return false;
        interface_.begin(session_.settings.interfaceScale);
        layOut();
        controls_.goOn(session_, interface_, elapsed);
        session_.measurements.frame.add(1000 * elapsed);
        double other = simulate(elapsed);
        observe();

        // Panels first: what they change is in this frame's picture already.
        drawPanels(session_, interface_, drafts_);
        other += drawScene();
        {
            const gpu::TimedPass timed(session_.measuring ? &drawingTimer_ : nullptr, "panels");
            interface_.draw();
        }
        // All that `sunder run` has not.
        session_.measurements.interface.add(1000 * (secondsSince(start) - other));
        window_.swap();

        ++frames_;
        sayErrors();
        logStatus();
        return true;
    }

    /// What mouse and keyboard did since the last frame, one after the other. Panels have a frame
    /// of their own, which nobody sees, for each that they may have to tell from the next: ImGui
    /// sees how things are and not what happened, and widgets want the mouse over them before a
    /// button goes down, and down before it goes up. False: the user quits.
    bool replay() {
        using Kind = window::InputEvent::Kind;
        for (const window::InputEvent& event : window_.input().events) {
            const bool counts = event.kind == Kind::Press || event.kind == Kind::Release ||
                                event.kind == Kind::Wheel || event.kind == Kind::KeyDown ||
                                event.kind == Kind::KeyUp;
            if (counts && interface_.fed()) showPanels(nullptr);
            interface_.feed(event);
            if (!(counts ? showPanels(&event) : controls_.take(session_, interface_, event)))
                return false;
        }
        return true;
    }

    /// What is let go of as the window is minimised; nothing is pressed then.
    void letGo() {
        using Kind = window::InputEvent::Kind;
        for (const window::InputEvent& event : window_.input().events) {
            interface_.feed(event);
            if (event.kind == Kind::Release || event.kind == Kind::Blur)
                controls_.take(session_, interface_, event);
        }
    }

    /// To themselves alone, with what has just happened.
    bool showPanels(const window::InputEvent* event) {
        interface_.begin(session_.settings.interfaceScale);
        layOut();
        const bool goOn = !event || controls_.take(session_, interface_, *event);
        drawPanels(session_, interface_, drafts_);
        interface_.end();
        return goOn;
    }

    /// Each kind as it begins; how much it comes to is among the measurements.
    void sayLosses() {
        const std::vector<std::string> notes =
            lossNotes(session_.stage->simulation.world(), session_.stage->simulation.solver());
        if (notes.size() > losses_) session_.say(notes.back());
        losses_ = notes.size();
    }

    /// Each once: a broken draw reports the same every frame.
    void sayErrors() {
        for (const std::string& error : window_.takeErrors()) {
            session_.log.add("gl_error", {{"text", error}});
            if (saidErrors_.insert(error).second) session_.say("OpenGL: " + error, true);
        }
    }

    /// The scene has what the panel leaves of the window.
    void layOut() {
        const int panel =
            session_.settings.panel
                ? static_cast<int>(std::lround(panelWidth(interface_) * interface_.density()))
                : 0;
        const int left = std::min(panel, window_.width() - 1);
        session_.area = {left, 0, std::max(1, window_.width() - left),
                         std::max(1, window_.height())};
        session_.keepHome();
    }

    /// Returns how long it took, s.
    double simulate(double elapsed) {
        PlayedScene& simulation = session_.stage->simulation;
        const int steps = session_.clock.tick(elapsed);
        controls_.holdHits(session_, steps * simulation.world().step());
        const std::vector<Push> pushes = session_.takePushes();
        if (!pushes.empty()) session_.log.add("pushed", {{"steps", steps}});
        // Passes are only timed while somebody looks: in software each of them is waited for.
        simulation.timePasses(session_.measuring ? &simulationTimer_ : nullptr);
        const auto start = Instant::now();
        simulation.advance(pushes, steps);
        const double cost = secondsSince(start);
        session_.clock.took(steps, cost);
        session_.measurements.simulation.add(1000 * cost);
        return cost;
    }

    /// What is found out now and then, or only for who looks.
    void observe() {
        Measurements& measurements = session_.measurements;
        PlayedScene& simulation = session_.stage->simulation;
        for (const Incident& incident : simulation.takeIncidents())
            ++(incident.kind == Incident::Kind::Break ? measurements.breaks
                                                      : measurements.contacts);
        sayLosses();
        if (session_.measuring || session_.log.enabled())
            diagnosis_.now([&] {
                measurements.diagnostics = diagnose(simulation.world(), simulation.state());
            });
        shaderLook_.now([&] { session_.watchShaders(); });
        session_.forgetOldMessages();
    }

    /// Returns how long it took, s.
    double drawScene() {
        const auto start = Instant::now();
        Stage& stage = *session_.stage;
        const Settings& settings = session_.settings;
        render::RenderSettings render;
        render.width = session_.area.width;
        render.height = session_.area.height;
        render.samples = settings.samples;
        render.mesh = settings.mesh;
        render.style = settings.style;
        if (settings.colour != render::WallColour::Material) {
            stage.colours.update(stage.simulation.state(), settings.colour);
            render.colours = &stage.colours;
        }
        if (session_.measuring) render.timer = &drawingTimer_;
        interface_.clear();
        const Drawn wanted{session_.generation(),
                           stage.simulation.changes(),
                           session_.camera.description(),
                           {render.width, render.height, render.samples},
                           render.mesh,
                           render.style};
        // Colours of what is measured adapt from frame to frame, and who measures wants to know
        // what drawing costs.
        still_ = wanted == drawn_ && !render.colours && !session_.measuring;
        if (!still_) {
            stage.renderer.render(stage.simulation.view(), wanted.camera, render);
            ++pictures_;
        }
        drawn_ = render.colours ? std::nullopt : std::optional(wanted);
        if (session_.pictureWanted()) session_.savePicture(stage.renderer.read());
        if (session_.recording() && !session_.clock.paused())
            session_.record(stage.renderer.read());
        stage.renderer.show(session_.area.left,
                            window_.height() - session_.area.top - session_.area.height);
        if (session_.measuring) {
            session_.measurements.addPasses(simulationTimer_.take());
            session_.measurements.addPasses(drawingTimer_.take());
        }
        const double cost = secondsSince(start);
        session_.measurements.drawing.add(1000 * cost);
        return cost;
    }

    void logStatus() {
        if (!session_.log.enabled()) return;
        status_.now([&] {
            if (interface_.widgets() != loggedWidgets_) writeWidgets();
            writeStatus();
        });
    }

    /// Where they are now, pixels: left, top, right, bottom.
    void writeWidgets() {
        loggedWidgets_ = interface_.widgets();
        nlohmann::ordered_json places = nlohmann::ordered_json::object();
        for (const auto& [name, place] : loggedWidgets_) places[name] = place;
        session_.log.add("widgets", {{"places", places}});
    }

    void writeStatus() {
        const Settings& settings = session_.settings;
        const Measurements& m = session_.measurements;
        const scene::Scene& scene = session_.scene();
        nlohmann::ordered_json materials = nlohmann::ordered_json::array();
        for (const Material& material : scene.world.materials) materials.push_back(material.name);
        const ViewArea& area = session_.area;
        const scene::CameraDescription camera = session_.camera.description();
        const Vec3 &eye = camera.position, &target = camera.target;
        session_.log.add(
            "status",
            {{"time", session_.stage->simulation.time()},
             {"scene", scene.name},
             {"seed", scene.world.seed},
             {"materials", materials},
             {"solver", session_.stage->simulation.solverInfo().name},
             {"mesh", toString(settings.mesh)},
             {"style", toString(settings.style)},
             {"colour", toString(settings.colour)},
             {"samples", settings.samples},
             {"tool", toString(settings.tool)},
             {"paused", session_.clock.paused()},
             {"speed", session_.clock.speed()},
             {"share", session_.clock.share()},
             {"dropped", session_.clock.dropped()},
             {"tetrahedra", kTetrahedraPerCell * session_.stage->simulation.world().presentCells()},
             {"looked_at", session_.lookedAt.value_or(-1)},
             {"bonds_broken", m.diagnostics.bondsBroken},
             {"pieces", m.diagnostics.pieces},
             {"nan", m.diagnostics.nan},
             {"window", {window_.width(), window_.height()}},
             {"minimised", window_.minimised()},
             {"focused", window_.focused()},
             {"full_screen", window_.fullScreen()},
             {"view", {area.left, area.top, area.width, area.height}},
             {"camera",
              {{"position", {eye[0], eye[1], eye[2]}},
               {"target", {target[0], target[1], target[2]}},
               {"field_of_view", camera.fieldOfView}}},
             {"pictures", pictures_},
             {"fps", m.framesPerSecond()},
             {"ms",
              {{"simulation", m.simulation.mean(30)},
               {"drawing", m.drawing.mean(30)},
               {"interface", m.interface.mean(30)}}},
             {"gl_bytes", gl::allocatedBytes()}});
    }

    /// Settings, and what was recorded; returns what became of that.
    std::string remember() {
        std::string recording;
        if (session_.recording()) recording = session_.endRecording();
        Settings& settings = session_.settings;
        // A settings file has its bounds.
        settings.width = std::clamp(window_.plainWidth(), 320, 16384);
        settings.height = std::clamp(window_.plainHeight(), 240, 16384);
        try {
            writeSettings(settingsFile(), settings);
        } catch (const InputError& error) {
            session_.log.add("problem", {{"text", error.what()}});
        }
        return recording;
    }

    /// What a picture depends on. The same again is not drawn again: a wall at rest leaves a laptop
    /// cool.
    struct Drawn {
        int generation;
        std::int64_t changes;
        scene::CameraDescription camera;
        std::array<int, 3> target;  ///< width, height, samples
        render::DrawnMesh mesh;
        render::DrawStyle style;
        bool operator==(const Drawn&) const = default;
    };

    window::Window& window_;
    Session session_;
    Interface interface_;
    Controls controls_;
    Drafts drafts_;
    gpu::PassTimer simulationTimer_{window_.info().software};
    gpu::PassTimer drawingTimer_{window_.info().software};
    Every diagnosis_{0.25, 0.05}, shaderLook_{0.5}, status_{0.02};
    std::map<std::string, Interface::Rectangle> loggedWidgets_;
    std::set<std::string> saidErrors_;
    std::size_t losses_ = 0;  ///< kinds of them
    std::int64_t frames_ = 0, pictures_ = 0;
    std::optional<Drawn> drawn_;  ///< where nothing but that decides what the picture is
    bool still_ = false;          ///< the last frame showed what the one before had drawn
};

}  // namespace

int view(const Options& options) {
    std::string problem;
    Settings settings;
    try {
        settings = readSettings(settingsFile());
    } catch (const InputError& error) {
        problem = std::string(error.what()) + "; the viewer starts with its own settings";
    }
    if (options.width > 0) {
        settings.width = options.width;
        settings.height = options.height;
        settings.fullScreen = false;
    }
    if (!options.solver.empty()) sim_gl::findSolver(options.solver);
    // What is wrong is a sentence, not a window that vanishes.
    startOverlaps(scene::loadScene(options.scene).world);
    if (!options.shaders.empty()) ShaderFolder check(options.shaders);
    window::Window::Options shown;
    shown.title = "Sunder";
    shown.width = settings.width;
    shown.height = settings.height;
    shown.fullScreen = settings.fullScreen;
    shown.vsync = settings.vsync;
    const auto window = window::Window::open(shown);
    // A first time without a GPU: what the CPU is good at.
    std::error_code error;
    if (window->info().software && !std::filesystem::exists(settingsFile(), error)) {
        settings.samples = 1;
        settings.solver = "cpu";
    }
    Viewer viewer(*window, options, settings);
    if (!problem.empty()) viewer.sayProblem(problem);
    return viewer.run();
}

}  // namespace sunder::view
