// sunder run: scene file → world → solver → node buffer → picture, without a screen.
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include "app/commands.hpp"
#include "app/frame_sinks.hpp"
#include "app/output_folder.hpp"
#include "app/progress.hpp"
#include "app/run_options.hpp"
#include "app/run_report.hpp"
#include "app/start.hpp"
#include "app/stopwatch.hpp"
#include "core/limit_notes.hpp"
#include "core/loss_notes.hpp"
#include "files/held_signals.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "image/image.hpp"
#include "render/legend.hpp"
#include "scene/scene.hpp"
#include "scene/vtu.hpp"
#include "sim/simulation.hpp"
#include "sim_gl/drawn_state.hpp"
#include "sim_gl/gl_layout.hpp"
#include "sim_gl/solvers.hpp"
#include "window/context.hpp"

namespace sunder::app {

using namespace core;

namespace {

namespace fs = std::filesystem;

/// The step stays near the scene's; a frame holds a whole number of them, so the physics hardly
/// depends on --fps.
int fitStepsToFrame(scene::Scene& scene, double fps) {
    const int steps = std::max(1, static_cast<int>(std::lround(1 / (fps * scene.world.step))));
    scene.world.step = 1 / (fps * steps);
    return steps;
}

/// Incidents in a frame that are not lost.
constexpr std::size_t kIncidentRoom = 65536;

/// Draws a solver's state.
class FramePainter {
  public:
    FramePainter(const scene::Scene& scene, sim::Simulation& simulation, window::Context& context,
                 const render::RenderSettings& settings, render::WallColour colour)
        : camera_(scene.camera),
          context_(context),
          simulation_(simulation),
          drawn_(simulation),
          renderer_(simulation.world(), *simulation.layout().buffers()),
          colour_(colour),
          colours_(simulation.world()),
          settings_(settings) {
        settings_.colours = &colours_;
        if (settings.mesh == render::DrawnMesh::Display && renderer_.displayMesh().simplified())
            std::cerr << "sunder: note: torn edges have fewer points than the materials ask for, "
                         "or they would be more than "
                      << surface::kMostDisplayVertices << " vertices\n";
    }

    Frame draw(int number, double time) {
        if (colour_ != render::WallColour::Material) colours_.update(simulation_.state(), colour_);
        image::Image plain = renderer_.draw(drawn_.view(), camera_, settings_);
        context_.check();  // before anything is made of a picture that failed
        image::Image withLegend = plain;
        render::drawLegend(withLegend, colours_.key());
        return {number, time, std::move(plain), colours_.key(), std::move(withLegend)};
    }

  private:
    scene::CameraDescription camera_;
    window::Context& context_;
    sim::Simulation& simulation_;
    sim_gl::DrawnState drawn_;
    render::Renderer renderer_;
    render::WallColour colour_;
    render::CellColours colours_;
    render::RenderSettings settings_;
};

/// Draws a frame if any sink wants it.
void deliver(int number, double fps, FramePainter& painter,
             const std::vector<std::unique_ptr<FrameSink>>& sinks) {
    std::optional<Frame> frame;
    for (const auto& sink : sinks) {
        if (!sink->wants(number)) continue;
        if (!frame) frame = painter.draw(number, number / fps);
        sink->take(*frame);
    }
}

/// Frame after frame to the last, or until a signal.
void play(const RunOptions& options, const std::string& name, sim::Simulation& simulation,
          FramePainter* painter, const std::vector<std::unique_ptr<FrameSink>>& sinks,
          RunFacts& facts) {
    Progress progress(name, facts.frames);
    for (int frame = 0; frame <= facts.frames && !files::notedSignal(); ++frame) {
        progress.update(frame);
        if (painter) deliver(frame, options.fps, *painter, sinks);
        if (frame == facts.frames) break;
        const Stopwatch watch;
        simulation.advance(facts.stepsPerFrame);
        simulation.finish();
        facts.msPerStep.push_back(1000 * watch.seconds() / facts.stepsPerFrame);
        facts.incidents.take(simulation);
    }
}

/// What is there of a run that was interrupted, and what is not. `problem`: what went wrong then.
std::string interruption(const RunFacts& facts,
                         const std::vector<std::unique_ptr<FrameSink>>& sinks,
                         const std::string& problem) {
    std::string said = "interrupted after " + std::to_string(facts.msPerStep.size()) + " of " +
                       std::to_string(facts.frames) + " frames: ";
    if (!problem.empty()) said += problem + ", ";
    for (const auto& sink : sinks)
        if (const std::string outcome = sink->outcome(); !outcome.empty()) said += outcome + ", ";
    return said + "there is no report";
}

/// Writes everything the user asked for about the last state; the report also goes beside the
/// pictures.
void writeResults(const RunOptions& options, const scene::Scene& scene, const World& world,
                  const State& state, const RunFacts& facts,
                  std::optional<files::HeldSignals>& held) {
    const std::string report = reportJson(scene, world, state, facts);
    files::writeFile(options.out / "report.json", report);
    // A pipe that nobody reads may keep the rest waiting for ever.
    held.reset();
    if (!options.json.empty()) files::writeFile(options.json, report);
    if (!options.state.empty()) files::writeFile(options.state, scene::toVtu(world, state));
}

int run(RunOptions options) {
    scene::Scene scene = scene::loadScene(options.scene);
    if (options.out.empty()) options.out = fs::path("out") / files::pathFromUtf8(scene.name);
    checkRunOptions(options);
    const sim::SolverInfo& solverInfo = sim_gl::findSolver(options.solver);
    const render::RenderSettings settings = renderSettings(options);
    if (options.seed) scene.world.seed = *options.seed;
    RunFacts facts;
    facts.solver = solverInfo.name;
    facts.frames = options.frames.value_or(
        std::max(1, static_cast<int>(std::lround(scene.frames * options.fps / 60))));
    facts.stepsPerFrame = fitStepsToFrame(scene, options.fps);
    const auto layout = std::make_shared<sim_gl::GlLayout>(scene.world);
    const World& world = layout->world();

    // Everything that can be refused is refused before the first file is made.
    const auto sinks = makeFrameSinks(options, scene.world, settings, facts.frames);
    std::unique_ptr<window::Context> context;
    if (!sinks.empty() || solverInfo.gpu) {
        context = window::createHeadlessContext();
        facts.renderer = context->info().renderer;
        layout->upload();
    }
    sim::Simulation simulation(layout, solverInfo, 0, kIncidentRoom);
    std::optional<FramePainter> painter;
    if (!sinks.empty()) painter.emplace(scene, simulation, *context, settings, wallColour(options));
    if (context) context->check();
    for (const std::string& note : core::limitNotes(world))
        std::cerr << "sunder: note: " << note << '\n';
    // Before signals are held: what interrupts it finds nothing to be finished.
    simulation.setState(startOf(scene, world));

    std::optional<files::HeldSignals> held(std::in_place);
    const OutputFolder folder(options.out);
    std::string problem;
    try {
        play(options, scene.name, simulation, painter ? &*painter : nullptr, sinks, facts);
        for (const auto& sink : sinks) sink->finish();
    } catch (const InputError& error) {
        // What ends this program may have ended ffmpeg as well.
        if (!files::notedSignal()) throw;
        problem = error.what();
    }
    if (const int signal = files::notedSignal()) {
        std::cerr << "sunder: " << interruption(facts, sinks, problem) << '\n';
        held->answer();
        return files::exitCodeOf(signal);
    }
    const Solver& solver = simulation.solver();
    facts.bodiesOnGpu = solver.bodiesOnGpu();
    for (const std::string& note : lossNotes(world, solver))
        std::cerr << "sunder: note: " << note << '\n';
    facts.losses.contacts = solver.droppedContacts();
    facts.losses.haste = solver.contactHaste();
    const State& state = simulation.state();
    facts.losses.sunk = sunkThings(world, state);
    if (const std::string note = sunkNote(facts.losses.sunk); !note.empty())
        std::cerr << "sunder: note: " << note << '\n';
    if (context) context->check();
    writeResults(options, scene, world, state, facts, held);
    std::cout << reportText(scene, world, state, facts);
    if (options.pngEvery > 0)
        std::cout << "pictures: " << files::utf8FromPath(options.out / "frame_*.png") << '\n';
    if (!options.contactSheet.empty())
        std::cout << "sheet:    " << files::utf8FromPath(options.contactSheet) << '\n';
    if (!options.video.empty())
        std::cout << "video:    " << files::utf8FromPath(options.video) << '\n';
    std::cout << "report:   " << files::utf8FromPath(options.out / "report.json") << '\n';
    return kDone;
}

}  // namespace

void addRun(CLI::App& app, Action& chosen) {
    CLI::App* command =
        app.add_subcommand("run", "Simulate a scene without a screen; write pictures and a report");
    auto options = std::make_shared<RunOptions>();
    addRunOptions(*command, *options);
    command->callback([&chosen, options] { chosen = [options] { return run(*options); }; });
}

}  // namespace sunder::app
