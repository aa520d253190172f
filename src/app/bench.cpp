// sunder bench: the performance test of the thesis's chapter 9, and what it leaves unsaid.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/bench_contest.hpp"
#include "app/bench_drawing.hpp"
#include "app/bench_library.hpp"
#include "app/bench_report.hpp"
#include "app/bench_scenes.hpp"
#include "app/bench_table.hpp"
#include "app/commands.hpp"
#include "app/machine.hpp"
#include "app/number_check.hpp"
#include "app/output_path.hpp"
#include "app/path_option.hpp"
#include "files/write_file.hpp"
#include "sim_gl/solvers.hpp"
#include "window/context.hpp"

namespace sunder::app {

using namespace core;

namespace {

constexpr int kExplosions = 100;  ///< at once

struct BenchOptions {
    std::string scene;
    std::vector<std::string> solvers;
    std::vector<int> threads;
    std::optional<int> walls;
    std::optional<int> repeats;
    bool quick = false;
    std::filesystem::path json, svg;
};

BenchLimits limitsFor(const BenchOptions& options) {
    BenchLimits limits;
    if (options.quick)
        limits = {.repeats = 2,
                  .secondsPerCell = 2,
                  .secondsPerRun = 0.05,
                  .framesPerRun = 2,
                  .drawnFramesPerRun = 2};
    limits.repeats = options.repeats.value_or(limits.repeats);
    return limits;
}

/// All solvers, or those the user names, threaded ones once per thread count.
std::vector<Entrant> entrants(const BenchOptions& options, bool gl) {
    std::vector<const sim::SolverInfo*> chosen;
    for (const std::string& name : options.solvers)
        chosen.push_back(&sim_gl::findSolver(name, "--solvers"));
    if (chosen.empty())
        for (const sim::SolverInfo& solver : sim_gl::solvers())
            if (gl || !solver.gpu) chosen.push_back(&solver);
    std::vector<int> threads = options.threads;
    if (threads.empty()) {
        threads = {1};
        if (coreCount() > 1) threads.push_back(coreCount());
    }
    std::vector<Entrant> result;
    const auto add = [&](const sim::SolverInfo* solver, int count) {
        const bool known = std::any_of(result.begin(), result.end(), [&](const Entrant& other) {
            return other.solver == solver && other.threads == count;
        });
        if (!known) result.push_back({solver, count});
    };
    for (const sim::SolverInfo* solver : chosen) {
        if (!solver->threaded) add(solver, 1);
        if (solver->threaded)
            for (const int count : threads) add(solver, count);
    }
    return result;
}

class Bench {
  public:
    Bench(BenchOptions options) : options_(std::move(options)), limits_(limitsFor(options_)) {}

    int run() {
        // Everything that can be refused is refused before the work.
        entrants(options_, true);
        scene::Scene scene =
            hitAtOnce(scene::loadScene(options_.scene.empty() ? "stress" : options_.scene));
        if (options_.walls) scene = withWalls(std::move(scene), *options_.walls);
        checkOutputs({{"--json", options_.json}, {"--svg", options_.svg}});
        openContext();
        entrants_ = entrants(options_, context_ != nullptr);
        report_.processor = processorName();
        report_.cores = coreCount();
        std::cout << machineLine(report_) << "\n\n";

        measureFrames(scene);
        if (options_.scene.empty()) {
            measureScaling();
            const scene::Scene wall = scalingScene(middleSize());
            measureBroken(wall);
            measurePeers();
        } else {
            measureBroken(scene);
        }
        if (context_) context_->check();
        if (!options_.json.empty()) files::writeFile(options_.json, benchJson(report_));
        if (!options_.svg.empty()) files::writeFile(options_.svg, benchSvg(report_));
        return kDone;
    }

  private:
    void openContext() {
        try {
            context_ = window::createHeadlessContext();
            report_.renderer = context_->info().renderer;
            report_.glVersion = context_->info().version;
        } catch (const DeviceError& error) {
            for (const std::string& name : options_.solvers)
                if (sim_gl::findSolver(name, "--solvers").gpu) throw;
            std::cerr << "sunder: note: CPU solvers only, and nothing is drawn: " << error.what()
                      << '\n';
        }
    }

    /// Large enough to fill the device, small enough for the slowest solver.
    int middleSize() const {
        if (options_.quick) return 2'000;
        return context_ && !context_->info().software ? 200'000 : 20'000;
    }

    void keep(const Results& results) {
        report_.results.insert(report_.results.end(), results.begin(), results.end());
    }

    void measureFrames(const scene::Scene& scene) {
        const auto measure = [&](const std::string& part, const scene::Scene& what) {
            Contest contest(what, entrants_, limits_, context_.get());
            Results results = contest.measure(part);
            contest.measureDrawn(results);
            if (part == "frames" && !options_.scene.empty()) contest.measureBreaking(results);
            keep(results);
            if (part == "frames") measurePictures(contest, what);
            return results;
        };
        const Results whole = measure("frames", scene);
        const Results oneStep = measure("one-step", oneStepPerFrame(scene));
        std::cout << scene.title << " (" << scene.name << "): " << whole.front().bodies
                  << (whole.front().bodies == 1 ? " body, " : " bodies, ")
                  << withCommas(whole.front().tetrahedra)
                  << " tetrahedra.\nA frame is 1/60 s of simulated time, a picture 1280x720, drawn "
                     "and read back.\n"
                  << framesText(whole, oneStep);
        if (options_.scene.empty())
            std::cout << "  The thesis, one step per frame, drawn: CPU 28, GPU 56 (Core 2 Duo "
                         "P7450, GeForce GT 230M); CPU 66, GPU 110 (Core i7 920, Radeon HD 4870 "
                         "X2).\n";
        else
            std::cout << '\n' << breakingText(whole) << '\n' << memoryText(whole);
        if (!report_.drawn.empty())
            std::cout << "\nDrawn in 1280x720 with shadows and four samples, not read back.\n"
                      << drawingText(report_.drawn, *report_.msDisplayMeshBuild);
        std::cout << std::endl;
        measureExplosions(scene);
        measureThroughLibrary(scene);
    }

    void measureExplosions(const scene::Scene& scene) {
        const auto measure = [&](const std::string& part, int count) {
            Contest contest(withExplosions(scene, count), entrants_, limits_, context_.get());
            Results results = contest.measure(part);
            keep(results);
            return results;
        };
        const Results calm = measure("calm", 0), blasts = measure("explosions", kExplosions);
        std::cout << explosionsText(calm, blasts, kExplosions) << std::endl;
    }

    void measureThroughLibrary(const scene::Scene& scene) {
        report_.library = measureLibrary(withExplosions(scene, 0), limits_, context_.get());
        std::cout << libraryText(report_.library) << std::endl;
    }

    /// What drawing costs beside simulating.
    void measurePictures(Contest& contest, const scene::Scene& scene) {
        if (!context_) return;
        Contest gather(scene, {{&sim_gl::findSolver("gather"), 1}}, limits_, context_.get());
        const auto measure = [&](const std::string& name, const State& state) {
            DrawingResult& result = report_.drawn.emplace_back(
                measureDrawing(scene, contest.world(), state, name, limits_));
            result.msGather = gather.measure("drawn", state).front().msPerFrame();
        };
        measure("intact", contest.start());
        measure("broken", contest.stateAfter(30));
        report_.msDisplayMeshBuild = measureDisplayMeshBuild(limits_);
    }

    void measureScaling() {
        Results all;
        std::vector<double> costs(entrants_.size(), 0);  // s per tetrahedron and step, last size
        for (const int size : scalingSizes()) {
            if (options_.quick && size > 20'000) break;
            const scene::Scene scene = scalingScene(size);
            const int fewest = fewestSteps(scene.world);
            std::vector<Entrant> fit;
            Results skipped;
            for (std::size_t i = 0; i < entrants_.size(); ++i) {
                const double seconds = costs[i] * size * fewest;
                if (seconds < limits_.secondsPerCell) {
                    fit.push_back(entrants_[i]);
                    continue;
                }
                BenchResult& result = skipped.emplace_back();
                result.part = "scaling";
                result.scene = scene.name;
                result.label = entrants_[i].label();
                result.solver = entrants_[i].solver->name;
                result.threads = entrants_[i].threads;
                result.tetrahedra = size;
                result.skipped = std::to_string(fewest) + " steps would take about " +
                                 shortNumber(seconds) + " s";
            }
            Contest contest(scene, fit, limits_, context_.get());
            Results results = contest.measure("scaling");
            for (const BenchResult& result : results)
                for (std::size_t i = 0; i < entrants_.size(); ++i)
                    if (entrants_[i].label() == result.label && result.skipped.empty())
                        costs[i] = result.nanosecondsPerTetrahedron() * 1e-9;
            results.insert(results.end(), skipped.begin(), skipped.end());
            all.insert(all.end(), results.begin(), results.end());
        }
        keep(all);
        std::cout
            << "One wooden wall that breaks (wood-wall), million tetrahedra per second and ns "
               "per tetrahedron and step.\n"
            << scalingText(all) << '\n'
            << memoryText(all) << std::endl;
    }

    /// The cost of a wall that stands against that of its pieces, and where a GPU's time goes.
    void measureBroken(const scene::Scene& scene) {
        Contest contest(scene, entrants_, limits_, context_.get());
        State whole = contest.start();
        // Past all events: it stands untouched.
        whole.step = std::int64_t{1} << 30;
        const Results intact = contest.measure("intact", whole);
        const Results broken = contest.measure("broken", contest.stateAfter(30));
        keep(intact);
        keep(broken);
        std::cout << scene.name << ", " << withCommas(intact.front().tetrahedra)
                  << " tetrahedra, intact and with "
                  << shortNumber(100 * broken.front().bondsBroken) << " % of its bonds broken.\n"
                  << brokenText(intact, broken) << std::endl;
        report_.passes = contest.measurePasses();
        if (report_.passes.empty()) return;
        std::cout << "Passes of the GPU solvers, medians of "
                  << (context_->info().software ? "times on the clock (a driver in software)"
                                                : "timer queries")
                  << "; " << scene.name << ", " << withCommas(report_.passes.front().tetrahedra)
                  << " tetrahedra.\n"
                  << passesText(report_.passes) << std::endl;
    }

    void measurePeers() {
        Results all;
        for (const char* name : {"peer-50x400", "peer-50x400-break"}) {
            Contest contest(hitAtOnce(scene::loadScene(name)), entrants_, limits_, context_.get());
            Results results = contest.measure("peers");
            contest.measureBreaking(results);
            all.insert(all.end(), results.begin(), results.end());
        }
        keep(all);
        std::cout << "Fifty walls of 400 tetrahedra, as measured for other libraries.\n"
                  << peersText(all) << std::endl;
    }

    BenchOptions options_;
    BenchLimits limits_;
    BenchReport report_;
    std::unique_ptr<window::Context> context_;
    std::vector<Entrant> entrants_;
};

}  // namespace

void addBench(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand(
        "bench", "Measure every solver: the thesis's fifty walls, all sizes, broken and intact");
    auto options = std::make_shared<BenchOptions>();
    command
        ->add_option("scene", options->scene,
                     "measure this one alone: a preset's name or a TOML file")
        ->type_name("SCENE");
    command->add_option("--solvers", options->solvers, "which ones (default: all)")
        ->delimiter(',')
        ->type_name("A,B,...");
    command
        ->add_option(
            "--threads", options->threads,
            "1 to 1024, of solvers that take several: one line for each count (default: 1,all)")
        ->delimiter(',')
        ->check(wholeNumber(1, 1024))
        ->type_name("1,2,...");
    command
        ->add_option("--walls", options->walls,
                     "1 to 10000 copies of the first body, in a grid (default: as in the scene)")
        ->check(wholeNumber(1, 10000))
        ->type_name("N");
    command
        ->add_option("--repeats", options->repeats,
                     "runs that each median is of, 1 to 1000 (default: 5)")
        ->check(wholeNumber(1, 1000))
        ->type_name("N");
    command->add_flag("--quick", options->quick, "a rough look, in seconds");
    addPath(*command, "--json", options->json, "also write all numbers to this file")
        ->type_name("FILE");
    addPath(*command, "--svg", options->svg,
            "also draw cost and throughput against size into this file")
        ->type_name("FILE");
    command->callback([&chosen, options] { chosen = [options] { return Bench(*options).run(); }; });
}

}  // namespace sunder::app
