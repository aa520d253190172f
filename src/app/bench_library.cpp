#include "app/bench_library.hpp"

#include <algorithm>
#include <functional>

#include "app/bench_table.hpp"
#include "app/machine.hpp"
#include "app/stopwatch.hpp"
#include "sim_gl/solvers.hpp"
#include "sunder/convert.hpp"
#include "sunder/gl.hpp"

namespace sunder::app {

namespace {

constexpr int kMostFrames = 300;

[[noreturn]] void fail(const Error& error) {
    if (error.code == Error::Code::Device) throw core::DeviceError(error.message);
    throw core::InputError(error.message);
}

template <class Work>
double milliseconds(const Work& work) {
    const Stopwatch watch;
    work();
    return 1000 * watch.seconds();
}

/// ms, until a world has one more body like its last, far from all others.
double extendTime(World& world, WorldDesc desc) {
    std::vector<double> times;
    for (int i = 0; i < 3; ++i) {
        BodyDesc more = desc.bodies.back();
        more.name.clear();
        more.position.x = 1000 + 100 * i;
        desc.addBody(more);
        times.push_back(milliseconds([&] {
            if (const auto done = world.extend(desc); !done) fail(done.error());
            if (const auto done = world.finish(); !done) fail(done.error());
        }));
    }
    return median(times);
}

/// Fills in times, or why there are none.
void measure(LibraryResult& result, const scene::Scene& scene, const sim_gl::GlLayout& layout,
             gl::Device* device, const BenchLimits& limits) {
    const auto& [info, threads] = result.entrant;
    const sim::MadeSolver made = info->make(layout, threads);
    Result<World> world = World::create(fromCore(scene.world), {.device = device,
                                                                .solver = info->name,
                                                                .threads = threads,
                                                                .incidents = 0,
                                                                .settle = false});
    if (!world) fail(world.error());
    const auto bySolver = [&](int steps) {
        return milliseconds([&] {
            made.solver->advance(steps);
            made.solver->finish();
        });
    };
    // A host waits by itself: this waits for all that the context was given.
    const auto byLibrary = [&](
                               int steps, const std::function<void()>& look = [] {}) {
        return milliseconds([&] {
            if (const auto done = world->step(steps * scene.world.step); !done) fail(done.error());
            look();
            made.solver->finish();
        });
    };
    // The first time, drivers compile what they need.
    const int steps = fewestSteps(scene.world);
    double taken = 0;
    for (int i = 0; i < 2; ++i) taken = bySolver(steps) + byLibrary(steps);
    const double frame = taken / steps * scene.substeps, room = 1000 * limits.secondsPerCell;
    if (frame * limits.repeats > room) {
        result.skipped = "a frame takes about " + shortNumber(frame / 2000) + " s";
        return;
    }
    result.frames = std::clamp(static_cast<int>(room / frame), limits.repeats, kMostFrames);
    std::vector<double> solver, library, ratios;
    for (int i = 0; i < result.frames; ++i) {
        // Whoever is first finds caches of the other.
        if (i % 2) library.push_back(byLibrary(scene.substeps));
        solver.push_back(bySolver(scene.substeps));
        if (i % 2 == 0) library.push_back(byLibrary(scene.substeps));
        ratios.push_back(library.back() / solver.back());
    }
    std::vector<double> looks;
    for (int i = 0; i < result.frames; ++i)
        looks.push_back(byLibrary(scene.substeps, [&] { world->castRay({0, 1, 10}, {0, 0, -1}); }));
    result.msSolver = median(solver);
    result.msLibrary = median(library);
    result.ratio = median(ratios);
    result.msLook = median(looks);
    result.msExtend = extendTime(*world, fromCore(scene.world));
}

}  // namespace

std::vector<LibraryResult> measureLibrary(const scene::Scene& scene, const BenchLimits& limits,
                                          const window::Context* context) {
    sim_gl::GlLayout layout(scene.world);
    std::vector<LibraryResult> results;
    const auto add = [&](const char* name, int threads, gl::Device* device) {
        LibraryResult& result = results.emplace_back();
        result.scene = scene.name;
        result.entrant = {&sim_gl::findSolver(name), threads};
        result.tetrahedra = core::kTetrahedraPerCell * layout.world().presentCells();
        try {
            if (device) layout.upload();
            measure(result, scene, layout, device, limits);
        } catch (const core::InputError& error) {  // there is no room for it
            result.skipped = error.what();
        }
    };
    add("cpu", coreCount(), nullptr);
    if (!context) return results;
    gl::Device device({.getProcAddress = context->loadFunction()});
    add("gather", 1, &device);
    return results;
}

std::string libraryText(const std::vector<LibraryResult>& results) {
    std::vector<std::vector<std::string>> rows{{"ms a frame", "by the solver alone",
                                                "through the library", "the library adds",
                                                "with a ray", "one more body"}};
    std::string skipped;
    for (const LibraryResult& result : results) {
        const std::string label = result.entrant.label();
        if (!result.skipped.empty())
            skipped += "  " + label + ": " + result.skipped + "\n";
        else
            rows.push_back({label, shortNumber(result.msSolver), shortNumber(result.msLibrary),
                            shortNumber(100 * (result.ratio - 1)) + " %",
                            shortNumber(result.msLook), shortNumber(result.msExtend)});
    }
    return textTable(rows) + skipped;
}

}  // namespace sunder::app
