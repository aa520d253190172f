#include "app/bench_drawing.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "app/bench_scenes.hpp"
#include "app/bench_table.hpp"
#include "app/stopwatch.hpp"
#include "sim_gl/deformed_mesh.hpp"
#include "surface/display_mesh.hpp"

namespace sunder::app {

using namespace core;

namespace {

constexpr int kMostPictures = 30;

/// ms each: as many in a row as fit.
double medianOf(const std::function<void()>& draw, const BenchLimits& limits) {
    const auto timed = [&](int pictures) {
        glFinish();
        const Stopwatch watch;
        for (int i = 0; i < pictures; ++i) draw();
        glFinish();
        return watch.seconds() / pictures;
    };
    timed(1);  // what is made when it is first needed
    const double estimate = timed(1);
    const int pictures =
        std::clamp(static_cast<int>(limits.secondsPerRun / estimate), 1, kMostPictures);
    std::vector<double> samples;
    for (int repeat = 0; repeat < limits.repeats; ++repeat)
        samples.push_back(1000 * timed(pictures));
    return median(samples);
}

}  // namespace

DrawingResult measureDrawing(const scene::Scene& scene, const World& world, const State& state,
                             const std::string& name, const BenchLimits& limits) {
    const gpu::WorldBuffers buffers(world);
    gpu::StateUpload upload(world);
    const gpu::StateView view = upload.upload(state);
    render::Renderer renderer(world, buffers);
    render::RenderSettings settings{.width = 1280, .height = 720, .samples = 4};
    DrawingResult result;
    result.scene = scene.name;
    result.state = name;
    result.bodies = static_cast<int>(world.bodies().size());
    result.cells = world.presentCells();
    result.vertices = renderer.displayMesh().vertices().size();
    result.triangles = renderer.displayMesh().indices().size() / 3;
    const auto picture = [&] { renderer.render(view, scene.camera, settings); };
    result.msDisplay = medianOf(picture, limits);
    settings.mesh = render::DrawnMesh::Simulation;
    result.msSimulation = medianOf(picture, limits);
    const sim_gl::DeformedMesh mesh(world, buffers, false);
    std::vector<int> bodies(world.bodies().size());
    std::iota(bodies.begin(), bodies.end(), 0);
    result.msSurface = medianOf([&] { mesh.update(view, bodies); }, limits);
    return result;
}

double measureDisplayMeshBuild(const BenchLimits& limits) {
    scene::Scene scene = scalingScene(2'000);
    scene.world.bodies[0].size = {5, 4, 0.1};
    scene.world.bodies[0].cells = {50, 40, 1};
    const World world(scene.world);
    std::vector<double> samples;
    for (int repeat = 0; repeat < limits.repeats; ++repeat) {
        const Stopwatch watch;
        const surface::DisplayMesh mesh(world);
        samples.push_back(1000 * watch.seconds());
    }
    return median(samples);
}

std::string drawingText(const std::vector<DrawingResult>& drawn, double msBuild) {
    std::vector<std::vector<std::string>> rows{{"ms per picture", "display mesh", "simulation mesh",
                                                "Surface::update", "1/60 s of gather",
                                                "display mesh / gather"}};
    for (const DrawingResult& result : drawn)
        rows.push_back({result.state, shortNumber(result.msDisplay),
                        shortNumber(result.msSimulation), shortNumber(result.msSurface),
                        shortNumber(result.msGather),
                        shortNumber(result.msDisplay / result.msGather)});
    const DrawingResult& any = drawn.front();
    return textTable(rows) + "  The display mesh has " + withCommas(any.vertices) +
           " vertices and " + withCommas(any.triangles) +
           " triangles. That of a wooden wall of 2,000 cells is made in " + shortNumber(msBuild) +
           " ms.\n";
}

}  // namespace sunder::app
