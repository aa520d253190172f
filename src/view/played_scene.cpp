#include "view/played_scene.hpp"

#include "sim_gl/gl_layout.hpp"
#include "sim_gl/solvers.hpp"

namespace sunder::view {

using namespace core;

namespace {

/// Those of a picture's time, and more than anybody looks at.
constexpr std::size_t kIncidentRoom = 4096;

std::shared_ptr<const sim::Layout> layOut(WorldDescription world, bool hits) {
    if (!hits) world.events.clear();
    auto layout = std::make_shared<sim_gl::GlLayout>(std::move(world));
    layout->upload();
    return layout;
}

}  // namespace

PlayedScene::PlayedScene(scene::Scene scene, const std::string& solver, bool hits,
                         const State* state)
    : scene_(std::move(scene)),
      simulation_(layOut(scene_.world, hits), sim_gl::findSolver(solver), 0, kIncidentRoom),
      drawn_(simulation_),
      atStart_(!state) {
    if (state)
        simulation_.setState(*state);
    else
        simulation_.restart();
}

void PlayedScene::setSolver(const std::string& name) {
    simulation_.setSolver(sim_gl::findSolver(name));
    ++changes_;
}

void PlayedScene::restart() {
    simulation_.restart();
    atStart_ = true;
    ++changes_;
}

void PlayedScene::push(const Push& push) {
    if (push.object >= 0) {
        if (world().objects()[push.object].inverseMass == 0) return;
        ObjectState object = simulation_.state().objects[push.object];
        object.velocity += push.velocity;
        simulation_.putObject(push.object, object);
        return;
    }
    EventDescription hit;
    hit.kind = EventDescription::Kind::Velocity;
    hit.body = kEveryBody;
    hit.point = push.place;
    hit.radius = push.radius;
    hit.vector = push.velocity;
    hit.falloff = true;
    hit.duration = world().step();
    simulation_.push(hit);
}

void PlayedScene::advance(const std::vector<Push>& pushes, int steps) {
    atStart_ &= pushes.empty() && steps < 1;
    const bool rested = pushes.empty() && simulation_.atRest();
    for (const Push& some : pushes) push(some);
    if (steps > 0) {
        simulation_.advance(steps);
        simulation_.finish();
    }
    // What begins to act, such as a hit of the scene, wakes what it acts on.
    const bool still = steps < 1 ? pushes.empty() : rested && simulation_.atRest();
    if (!still) ++changes_;
}

void PlayedScene::timePasses(gpu::PassTimer* timer) {
    if (gpu::GpuSolver* solver = simulation_.gpuSolver()) solver->setPassTimer(timer);
}

}  // namespace sunder::view
