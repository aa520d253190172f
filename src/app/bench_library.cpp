#include "app/bench_library.hpp"

#include <algorithm>
#include <chrono>

#include "app/bench_table.hpp"
#include "app/machine.hpp"
#include "sim_gl/solvers.hpp"
#include "sunder/convert.hpp"
#include "sunder/gl.hpp"

namespace sunder::app {

namespace {

constexpr int kMostFrames = 300;

template <class Work>
double milliseconds(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

template <class Value>
Value orThrow(Result<Value> result) {
    if (!result) throw core::InputError(result.error().message);
    return std::move(*result);
}

LibraryResult measure(const scene::Scene& scene, const sim::SolverInfo& info, int threads,
                      const sim_gl::GlLayout& layout, gl::Device* device,
                      const BenchLimits& limits) {
    const sim::MadeSolver made = info.make(layout, threads);
    World world = orThrow(World::create(fromCore(scene.world), {.device = device,
                                                                .solver = info.name,
                                                                .threads = threads,
                                                                .incidents = 0,
                                                                .settle = false}));
    const auto bySolver = [&] {
        made.solver->advance(scene.substeps);
        made.solver->finish();
    };
    const auto byLibrary = [&] {
        const bool done = world.step(scene.substeps * scene.world.step) && world.finish();
        if (!done) throw core::InputError("the library does not get through a frame");
    };
    // What is made when it is first needed.
    for (int i = 0; i < 2; ++i) {
        bySolver();
        byLibrary();
    }
    const double estimate = milliseconds(bySolver) + milliseconds(byLibrary);
    const int frames = std::clamp(static_cast<int>(1000 * limits.secondsPerCell / estimate),
                                  limits.repeats, kMostFrames);
    std::vector<double> solver, library, ratios;
    for (int frame = 0; frame < frames; ++frame) {
        // Whoever is first finds caches of the other.
        if (frame % 2) library.push_back(milliseconds(byLibrary));
        solver.push_back(milliseconds(bySolver));
        if (frame % 2 == 0) library.push_back(milliseconds(byLibrary));
        ratios.push_back(library.back() / solver.back());
    }
    return {scene.name,     Entrant{&info, threads}.label(),
            median(solver), median(library),
            median(ratios), frames};
}

}  // namespace

std::vector<LibraryResult> measureLibrary(const scene::Scene& scene, const BenchLimits& limits,
                                          const window::Context* context) {
    sim_gl::GlLayout layout(scene.world);
    std::vector<LibraryResult> results;
    results.push_back(
        measure(scene, sim_gl::findSolver("cpu"), coreCount(), layout, nullptr, limits));
    if (!context) return results;
    layout.upload();
    gl::Device device({.getProcAddress = context->loadFunction()});
    results.push_back(measure(scene, sim_gl::findSolver("gather"), 1, layout, &device, limits));
    return results;
}

std::string libraryText(const std::vector<LibraryResult>& results) {
    std::vector<std::vector<std::string>> rows{
        {"ms a frame", "by the solver alone", "through the library", "the library adds"}};
    for (const LibraryResult& result : results)
        rows.push_back({result.label, shortNumber(result.msSolver), shortNumber(result.msLibrary),
                        shortNumber(100 * (result.ratio - 1)) + " %"});
    return textTable(rows);
}

}  // namespace sunder::app
