#include "app/bench_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "core/orientation.hpp"

namespace sunder::app {

using namespace core;

namespace {

constexpr double kCell = 0.1;  // m

struct ScalingWall {
    int tetrahedra;
    IVec3 cells;
};

const std::vector<ScalingWall>& scalingWalls() {
    static const std::vector<ScalingWall> walls{{2'000, {20, 20, 1}},      {6'000, {40, 30, 1}},
                                                {20'000, {80, 50, 1}},     {60'000, {150, 80, 1}},
                                                {200'000, {250, 160, 1}},  {600'000, {300, 200, 2}},
                                                {2'000'000, {500, 400, 2}}};
    return walls;
}

}  // namespace

scene::Scene hitAtOnce(scene::Scene scene) {
    double first = 0;
    for (std::size_t i = 0; i < scene.world.events.size(); ++i)
        first = i == 0 ? scene.world.events[i].time : std::min(first, scene.world.events[i].time);
    for (EventDescription& event : scene.world.events) event.time -= first;
    return scene;
}

scene::Scene withWalls(scene::Scene scene, int walls) {
    const BodyDescription wall = scene.world.bodies.front();
    const std::vector<EventDescription> events = scene.world.events;
    scene.world.bodies.clear();
    scene.world.events.clear();
    // Wider than deep walls stand in about half as many columns as rows.
    const int columns = std::max(1, static_cast<int>(std::sqrt(walls / 2.0)));
    const Vec3 room = axesOf(wall.orientation).cwiseAbs() * wall.size;
    const double dx = 1.2 * room.x(), dz = room.z() + room.y();
    for (int i = 0; i < walls; ++i) {
        BodyDescription& copy = scene.world.bodies.emplace_back(wall);
        copy.name = wall.name + " " + std::to_string(i + 1);
        copy.position += Vec3(dx * (i % columns), 0, -dz * (i / columns));
        for (EventDescription event : events) {
            if (event.body != 0) continue;
            event.body = i;
            scene.world.events.push_back(event);
        }
    }
    return scene;
}

scene::Scene withExplosions(scene::Scene scene, int count) {
    core::WorldDescription& world = scene.world;
    world.events.clear();
    world.throws.clear();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        core::EventDescription push;
        push.body = static_cast<int>(i);
        push.point = {0, world.bodies[i].size[1] / 2, 0};
        push.radius = world.bodies[i].size[1];
        push.vector = {0, 0, 1e-6};
        push.duration = 1000;
        world.events.push_back(push);
    }
    for (int i = 0; i < count; ++i) {
        const core::BodyDescription& body = world.bodies[i % world.bodies.size()];
        core::EventDescription blast;
        blast.kind = core::EventDescription::Kind::Velocity;
        blast.body = core::kEveryBody;
        blast.point = body.position + core::Vec3(0, body.size[1] / 2, 0);
        blast.radius = 0.5;
        blast.outward = 1e-6;
        blast.falloff = true;
        blast.duration = 1000;
        world.events.push_back(blast);
    }
    return scene;
}

scene::Scene oneStepPerFrame(scene::Scene scene) {
    scene.substeps = 1;
    scene.world.step = 1.0 / 60;
    scene.world.fractureInterval = 1;
    return scene;
}

const std::vector<int>& scalingSizes() {
    static const std::vector<int> sizes = [] {
        std::vector<int> result;
        for (const ScalingWall& wall : scalingWalls()) result.push_back(wall.tetrahedra);
        return result;
    }();
    return sizes;
}

scene::Scene scalingScene(int tetrahedra) {
    const auto& walls = scalingWalls();
    const auto wall = std::find_if(walls.begin(), walls.end(), [&](const ScalingWall& known) {
        return known.tetrahedra == tetrahedra;
    });
    scene::Scene scene;
    scene.name = "wood-wall";
    scene.title = "A wooden wall, hit at 40 m/s";
    scene.world.materials = {scene::loadMaterial("wood")};
    BodyDescription body;
    body.name = "wall";
    body.cells = wall->cells;
    body.size = kCell * wall->cells.cast<double>();
    body.anchors = {Side::Bottom};
    const double height = body.size.y();
    EventDescription hit;
    hit.kind = EventDescription::Kind::Velocity;
    hit.point = Vec3(0, height / 2, body.size.z() / 2);
    hit.radius = 0.3 * height;
    hit.vector = Vec3(0, 0, -40);
    scene.camera.position = Vec3(0, height / 2, 3 * height);
    scene.camera.target = Vec3(0, height / 2, 0);
    scene.world.bodies = {body};
    scene.world.events = {hit};
    return scene;
}

}  // namespace sunder::app
