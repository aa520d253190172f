#include "view/played_scene.hpp"

namespace sunder::view {

using namespace core;

namespace {

/// Those of a picture's time, and more than anybody looks at.
constexpr std::size_t kIncidentRoom = 4096;

std::shared_ptr<const sim::Layout> layOut(WorldDescription world, bool hits) {
    if (!hits) world.events.clear();
    auto layout = std::make_shared<sim::Layout>(std::move(world));
    layout->upload();
    return layout;
}

}  // namespace

PlayedScene::PlayedScene(scene::Scene scene, const std::string& solver, bool hits,
                         const State* state)
    : scene_(std::move(scene)),
      simulation_(layOut(scene_.world, hits), sim::findSolver(solver), 0, kIncidentRoom),
      atStart_(!state) {
    if (state)
        simulation_.setState(*state);
    else
        simulation_.restart();
}

void PlayedScene::setSolver(const std::string& name) {
    simulation_.setSolver(sim::findSolver(name));
}

void PlayedScene::restart() {
    simulation_.restart();
    atStart_ = true;
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
    for (const Push& some : pushes) push(some);
    if (steps < 1) return;
    simulation_.advance(steps);
    simulation_.finish();
}

}  // namespace sunder::view
