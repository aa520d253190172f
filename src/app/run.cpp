// sunder run: scene file → world → solver → node buffer → picture, without a screen.
#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>

#include "app/commands.hpp"
#include "app/output_path.hpp"
#include "app/progress.hpp"
#include "app/run_report.hpp"
#include "app/solver_factory.hpp"
#include "balance/balanced_solver.hpp"
#include "core/vtu.hpp"
#include "gl/context.hpp"
#include "image/image.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace sunder::app {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
    std::string scene;
    std::string solver = "gather";
    std::optional<int> frames;
    double fps = 60;
    std::optional<std::uint64_t> seed;
    std::string size = "1280x720";
    std::string out;
    int pngEvery = 20;
    std::string mesh = "display";
    std::string style = "solid";
    std::string json;
    std::string state;
};

RenderSettings renderSettings(const RunOptions& options) {
    RenderSettings settings;
    // Not sscanf: it takes 4294967456 for 160.
    const char *text = options.size.data(), *end = text + options.size.size();
    const auto width = std::from_chars(text, end, settings.width);
    const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = separated ? std::from_chars(width.ptr + 1, end, settings.height) : width;
    if (!separated || height.ec != std::errc() || height.ptr != end || settings.width < 16 ||
        settings.height < 16 || settings.width > 8192 || settings.height > 8192)
        throw InputError("--size: '" + options.size +
                         "' is not WIDTHxHEIGHT with both from 16 to 8192, for example 1280x720");
    if (options.mesh == "simulation") settings.mesh = DrawnMesh::Simulation;
    if (options.style == "wireframe") settings.style = DrawStyle::Wireframe;
    if (options.style == "overlay") settings.style = DrawStyle::Overlay;
    return settings;
}

/// CLI11 alone takes -1 for 2^64 - 1. Says what is wrong, if anything.
std::string checkSeed(const std::string& text) {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, seed);
    if (result.ec == std::errc() && result.ptr == end) return {};
    return "'" + text + "' is not a whole number from 0 to 18446744073709551615";
}

/// The step stays near the scene's; a frame holds a whole number of them, so the physics hardly
/// depends on --fps.
int fitStepsToFrame(Scene& scene, double fps) {
    const int steps = std::max(1, static_cast<int>(std::lround(1 / (fps * scene.world.step))));
    scene.world.step = 1 / (fps * steps);
    return steps;
}

/// Incidents in a frame that are not lost.
constexpr std::size_t kIncidentRoom = 65536;

/// Draws frames into DIR/frame_0000.png, … .
class FrameWriter {
  public:
    FrameWriter(const Scene& scene, const World& world, Solver& solver,
                const gpu::WorldBuffers& buffers, RenderSettings settings, fs::path folder)
        : camera_(scene.camera),
          renderer_(world, buffers),
          view_(world, solver),
          settings_(settings),
          folder_(std::move(folder)) {}

    void write(int frame) {
        char name[32];
        std::snprintf(name, sizeof name, "frame_%04d.png", frame);
        writePng(folder_ / name, renderer_.draw(view_.view(), camera_, settings_));
    }

  private:
    CameraDescription camera_;
    Renderer renderer_;
    SolverView view_;
    RenderSettings settings_;
    fs::path folder_;
};

/// Writes everything the user asked for about the last state; with pictures, the report also goes
/// beside them.
void writeResults(const RunOptions& options, const Scene& scene, const World& world,
                  const State& state, const RunFacts& facts) {
    const std::string report = reportJson(scene, world, state, facts);
    if (!options.out.empty()) writeFileAtomically(fs::path(options.out) / "report.json", report);
    if (!options.json.empty()) writeFileAtomically(options.json, report);
    if (!options.state.empty()) writeFileAtomically(options.state, toVtu(world, state));
}

int run(RunOptions options) {
    Scene scene = loadScene(options.scene);
    const SolverInfo& solverInfo = findSolver(options.solver);
    const RenderSettings settings = renderSettings(options);
    if (!(options.fps >= 1 && options.fps <= 1000))  // CLI::Range lets nan through
        throw InputError("--fps: it must be from 1 to 1000");
    if (options.seed) scene.world.seed = *options.seed;
    RunFacts facts;
    facts.solver = solverInfo.name;
    facts.frames = options.frames.value_or(
        std::max(1, static_cast<int>(std::lround(scene.frames * options.fps / 60))));
    facts.stepsPerFrame = fitStepsToFrame(scene, options.fps);
    if (options.out.empty()) options.out = (fs::path("out") / scene.name).string();
    for (const std::string& path : {options.json, options.state}) checkWritable(path, options.out);
    const World world(scene.world);

    // Everything that can be refused is refused before the first file is made.
    const bool pictures = options.pngEvery > 0;
    std::unique_ptr<gl::Context> context;
    std::optional<gpu::WorldBuffers> buffers;
    if (pictures || solverInfo.gpu) {
        context = gl::createHeadlessContext();
        facts.renderer = context->info().renderer;
        buffers.emplace(world);
    }
    IncidentRing incidents(kIncidentRoom);
    const std::unique_ptr<Solver> solver =
        makeSolver(solverInfo, world, buffers ? &*buffers : nullptr);
    solver->setIncidents(&incidents);
    std::optional<FrameWriter> frameWriter;
    if (pictures) frameWriter.emplace(scene, world, *solver, *buffers, settings, options.out);
    if (context) context->check();
    std::error_code error;
    fs::create_directories(options.out, error);
    if (error)
        throw InputError("--out: cannot make the folder '" + options.out + "': " + error.message());

    for (const std::string& warning : limitWarnings(scene, world))
        std::cerr << "sunder: note: " << warning << '\n';
    {
        Progress progress(scene.name, facts.frames);
        for (int frame = 0; frame <= facts.frames; ++frame) {
            progress.update(frame);
            if (pictures && (frame % options.pngEvery == 0 || frame == facts.frames))
                frameWriter->write(frame);
            if (frame == facts.frames) break;
            const auto start = std::chrono::steady_clock::now();
            solver->advance(facts.stepsPerFrame);
            solver->finish();
            const std::chrono::duration<double, std::milli> elapsed =
                std::chrono::steady_clock::now() - start;
            facts.msPerStep.push_back(elapsed.count() / facts.stepsPerFrame);
            facts.incidents.take(incidents);
        }
    }
    if (const auto* shared = dynamic_cast<const BalancedSolver*>(solver.get()))
        facts.bodiesOnGpu = shared->bodiesOnGpu();
    if (const auto* onGpu = dynamic_cast<const gpu::GpuSolver*>(solver.get());
        onGpu && onGpu->droppedContacts() > 0)
        std::cerr << "sunder: note: up to " << onGpu->droppedContacts()
                  << " contacts at a time found no room and were left out; --solver cpu has room "
                     "for all\n";
    const State state = solver->state();
    if (context) context->check();
    writeResults(options, scene, world, state, facts);
    std::cout << reportText(scene, world, state, facts);
    if (pictures)
        std::cout << "pictures: " << (fs::path(options.out) / "frame_*.png").string() << '\n';
    std::cout << "report:   " << (fs::path(options.out) / "report.json").string() << '\n';
    return kDone;
}

}  // namespace

void addRun(CLI::App& app, Action& chosen) {
    CLI::App* command =
        app.add_subcommand("run", "Simulate a scene without a screen; write pictures and a report");
    auto options = std::make_shared<RunOptions>();
    command
        ->add_option("scene", options->scene, "a preset's name (see: sunder list) or a TOML file")
        ->required()
        ->type_name("SCENE");
    command->add_option("--solver", options->solver, "see: sunder list")->capture_default_str();
    command->add_option("--frames", options->frames, "how many frames (default: the scene's)")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--fps", options->fps, "frames per second of simulated time, 1 to 1000")
        ->capture_default_str();
    command->add_option("--seed", options->seed, "of the strength map (default: the scene's)")
        ->check(checkSeed, "");
    command->add_option("--size", options->size, "of pictures")
        ->type_name("WxH")
        ->capture_default_str();
    command
        ->add_option("--out", options->out,
                     "folder for pictures and report.json (default: out/SCENE)")
        ->type_name("DIR");
    command
        ->add_option("--frames-png", options->pngEvery,
                     "a picture every so many frames, and of the last; 0: none")
        ->check(CLI::Range(0, 1000000))
        ->type_name("EVERY")
        ->capture_default_str();
    command
        ->add_option("--mesh", options->mesh,
                     "what is drawn of walls: display (torn edges) or simulation (tetrahedra)")
        ->check(CLI::IsMember({"display", "simulation"}))
        ->capture_default_str();
    command
        ->add_option("--style", options->style, "how walls are drawn: solid, wireframe or overlay")
        ->check(CLI::IsMember({"solid", "wireframe", "overlay"}))
        ->capture_default_str();
    command->add_option("--state", options->state, "write the last state as .vtu (ParaView)")
        ->type_name("FILE.vtu");
    command->add_option("--json", options->json, "also write the report here")->type_name("FILE");
    command->callback([&chosen, options] { chosen = [options] { return run(*options); }; });
}

}  // namespace sunder::app
