// Scene files: refused in a sentence, or laid out, simulated for a few steps and written back.
#include "core/diagnostics.hpp"
#include "cpu/cpu_solver.hpp"
#include "fuzz/fuzzer.hpp"
#include "scene/scene.hpp"
#include "scene/scene_writer.hpp"
#include "scene/vtu.hpp"
#include "surface/display_mesh.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

// So that an input takes milliseconds.
constexpr std::int64_t kFewCells = 64;
constexpr std::size_t kFewEvents = 64;

bool small(const WorldDescription& world) {
    std::int64_t cells = 0;
    for (const BodyDescription& body : world.bodies)
        cells += std::int64_t{body.cells[0]} * body.cells[1] * body.cells[2];
    return cells <= kFewCells && world.events.size() + world.throws.size() <= kFewEvents;
}

void simulate(const WorldDescription& description) {
    const World world(description);
    cpu::CpuSolver solver(world, 1);
    solver.advance(40);  // a search for contacts is among them
    const State state = solver.state();
    diagnose(world, state);
    scene::toVtu(world, state);
    surface::DisplayMesh mesh(world, 100'000);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    scene::Scene scene;
    try {
        scene = scene::parseScene(fuzz::text(data, size), "fuzz.toml", {});
    } catch (const InputError& error) {
        fuzz::checkSentence(error);
        return 0;
    }
    // Nothing refuses what Sunder itself wrote.
    scene::parseScene(scene::writeScene(scene), "written.toml", {});
    if (!small(scene.world)) return 0;
    try {
        simulate(scene.world);
    } catch (const InputError& error) {
        fuzz::checkSentence(error);
    }
    return 0;
}
