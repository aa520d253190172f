// Parts of the viewer that need no window: picking, pushing, settings, names of files.
#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "scene/scene.hpp"
#include "support/test_folder.hpp"
#include "surface/picker.hpp"
#include "view/settings.hpp"
#include "view/shader_folder.hpp"

using namespace sunder;
using namespace sunder::core;
using namespace sunder::view;

namespace {

namespace fs = std::filesystem;

/// 3 × 2 × 0.1 m, front at z = 0.05.
const World& wall() {
    static const World world(scene::loadScene("wood").world);
    return world;
}

const surface::DisplayMesh& wallMesh() {
    static const surface::DisplayMesh mesh(wall());
    return mesh;
}

}  // namespace

TEST_CASE("A ray finds the spot on the wall at rest", "[view]") {
    const surface::Picker picker(wall(), wallMesh());
    const State state = wall().initialState();
    for (const double x : {-1.4, -0.333, 0.0, 0.71, 1.49})
        for (const double y : {0.02, 0.9, 1.96}) {
            INFO(x << ", " << y);
            const auto front = picker.pick(state, Vec3(x, y, 4), Vec3(0, 0, -1));
            REQUIRE(front);
            CHECK(front->place[2] == Approx(0.05).margin(1e-4));
            CHECK(front->distance == Approx(3.95).margin(1e-4));
            // The cell is at the spot.
            const Body& body = wall().bodies()[0];
            const IVec3 at = body.coordinates(front->cell);
            const Vec3 low = body.origin + at.cast<double>().cwiseProduct(body.cellSize);
            CHECK((front->place - (low + body.cellSize / 2)).norm() < 1.8 * body.cellSize.norm());
            const auto back = picker.pick(state, Vec3(x, y, -4), Vec3(0, 0, 1));
            REQUIRE(back);
            CHECK(back->place[2] == Approx(-0.05).margin(1e-4));
        }
    CHECK_FALSE(picker.pick(state, Vec3(1.6, 1, 4), Vec3(0, 0, -1)));
    CHECK_FALSE(picker.pick(state, Vec3(0, 1, 4), Vec3(0, 0, 1)));  // behind
}

TEST_CASE("A ray finds the spot on a turned wall", "[view]") {
    WorldDescription d = wall().description();
    const Mat3 turn = Eigen::AngleAxisd(0.9, Vec3(2, 1, -2) / 3).toRotationMatrix();
    d.bodies[0].orientation = turn;
    d.ground = false;
    const World world(d);
    const surface::DisplayMesh mesh(world);
    const surface::Picker picker(world, mesh), upright(wall(), wallMesh());
    const State state = world.initialState();
    const Vec3 about = d.bodies[0].position;
    for (const double x : {-1.4, -0.333, 0.0, 0.71, 1.49}) {
        const Vec3 eye(x, 0.9, 4), ahead(0.1, 0, -1);
        const auto spot =
            picker.pick(state, about + turn * (eye - about), turn * ahead.normalized());
        const auto other = upright.pick(wall().initialState(), eye, ahead.normalized());
        REQUIRE(spot.has_value() == other.has_value());
        if (!spot) continue;
        CHECK(spot->cell == other->cell);
        CHECK((spot->place - about - turn * (other->place - about)).norm() < 1e-4);
    }
    CHECK(picker.pick(state, about + turn * Vec3(0, 0.9, 4), turn * Vec3(0, 0, -1)));
    CHECK_FALSE(picker.pick(state, about + turn * Vec3(1.6, 1, 4), turn * Vec3(0, 0, -1)));
}

TEST_CASE("A ray finds the wall where it has gone", "[view]") {
    const surface::Picker picker(wall(), wallMesh());
    State state = wall().initialState();
    for (Vec3& displacement : state.displacement) displacement = Vec3(0.7, 0.3, -1);
    const auto spot = picker.pick(state, Vec3(2, 1, 4), Vec3(0, 0, -1));
    REQUIRE(spot);
    CHECK(spot->place[2] == Approx(-0.95).margin(1e-4));
    CHECK_FALSE(picker.pick(state, Vec3(-1, 1, 4), Vec3(0, 0, -1)));
}

TEST_CASE("A ray passes through the hole that a cell left", "[view]") {
    const surface::Picker picker(wall(), wallMesh());
    State state = wall().initialState();
    const Vec3 origin(0.05, 1.05, 4), ahead(0, 0, -1);
    REQUIRE(picker.pick(state, origin, ahead));
    // Everything around the ray flies off sideways, one cell by itself.
    const Body& body = wall().bodies()[0];
    for (int cell = 0; cell < wall().cellCount(); ++cell) {
        const Vec3 low =
            body.origin + body.coordinates(cell).cast<double>().cwiseProduct(body.cellSize);
        if (std::abs(low[0] + 0.05 - origin[0]) > 0.25 ||
            std::abs(low[1] + 0.05 - origin[1]) > 0.25)
            continue;
        for (int corner = 0; corner < kCorners; ++corner)
            state.displacement[kCorners * cell + corner] = Vec3(10, 0, 0);
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                const int neighbour = wall().neighbour(cell, axis, side);
                if (neighbour < 0) continue;
                state.damage[kBondsPerCell * (side > 0 ? cell : neighbour) + axis] = 1;
            }
    }
    CHECK_FALSE(picker.pick(state, origin, ahead));
    CHECK(picker.pick(state, origin + Vec3(10, 0, 0), ahead));
    CHECK(picker.pick(state, origin + Vec3(0.5, 0, 0), ahead));
}

TEST_CASE("A ray finds the object in front of the wall", "[view]") {
    scene::Scene scene = scene::loadScene("wood");
    scene.world.contact = true;
    ObjectDescription ball;
    ball.name = "ball";
    ball.halfSize.setConstant(0.2);
    ball.mass = 5;
    ball.position = Vec3(0, 1, 2);
    ObjectDescription box = ball;
    box.name = "box";
    box.shape = ObjectShape::Box;
    box.halfSize = Vec3(0.1, 0.3, 0.2);
    box.position = Vec3(1, 1, 1);
    scene.world.objects = {ball, box};
    const World world(scene.world);
    const surface::DisplayMesh mesh(world);
    const surface::Picker picker(world, mesh);
    State state = world.initialState();
    const auto first = picker.pick(state, Vec3(0, 1, 4), Vec3(0, 0, -1));
    REQUIRE(first);
    CHECK(first->object == 0);
    CHECK(first->distance == Approx(1.8));
    const auto second = picker.pick(state, Vec3(1, 1.25, 4), Vec3(0, 0, -1));
    REQUIRE(second);
    CHECK(second->object == 1);
    CHECK(second->distance == Approx(2.8));
    state.objects[0].present = false;
    const auto behind = picker.pick(state, Vec3(0, 1, 4), Vec3(0, 0, -1));
    REQUIRE(behind);
    CHECK(behind->object == -1);
    CHECK(behind->cell >= 0);
}

TEST_CASE("Settings are remembered", "[view]") {
    const TestFolder folder;
    const fs::path file = folder.path() / "deep" / "viewer.toml";
    CHECK(readSettings(file).solver == "gather");  // none yet
    Settings settings;
    settings.solver = "scatter";
    settings.mesh = render::DrawnMesh::Simulation;
    settings.style = render::DrawStyle::Overlay;
    settings.colour = render::WallColour::Piece;
    settings.samples = 8;
    settings.vsync = false;
    settings.fullScreen = true;
    settings.tool = Tool::Pull;
    settings.shot = 12.5;
    settings.push = 333;
    settings.radius = 0.07;
    settings.sceneHits = true;
    settings.interfaceScale = 1.75;
    settings.panel = false;
    settings.width = 1601;
    settings.height = 899;
    writeSettings(file, settings);
    const Settings again = readSettings(file);
    CHECK(again.solver == settings.solver);
    CHECK(again.mesh == settings.mesh);
    CHECK(again.style == settings.style);
    CHECK(again.colour == settings.colour);
    CHECK(again.samples == settings.samples);
    CHECK(again.vsync == settings.vsync);
    CHECK(again.fullScreen == settings.fullScreen);
    CHECK(again.tool == settings.tool);
    CHECK(again.shot == settings.shot);
    CHECK(again.push == settings.push);
    CHECK(again.radius == settings.radius);
    CHECK(again.sceneHits == settings.sceneHits);
    CHECK(again.interfaceScale == settings.interfaceScale);
    CHECK(again.panel == settings.panel);
    CHECK(again.width == settings.width);
    CHECK(again.height == settings.height);
}

TEST_CASE("A settings file with a mistake is named, with its line", "[view]") {
    const TestFolder folder;
    const fs::path file = folder.path() / "viewer.toml";
    std::ofstream(file) << "vsync = true\nsolver = \"fastest\"\n";
    CHECK_THROWS_WITH(readSettings(file), Catch::Contains("viewer.toml:2") &&
                                              Catch::Contains("solver") &&
                                              Catch::Contains("gather"));
}

TEST_CASE("A folder of shaders is read as it is, and tells that it changed", "[view]") {
    const TestFolder folder;
    CHECK_THROWS_WITH(ShaderFolder(folder.path()), Catch::Contains("--shader-dir"));
    fs::create_directories(folder.path() / "draw");
    const fs::path file = folder.path() / "draw" / "sky.frag";
    std::ofstream(file) << "one";
    ShaderFolder shaders(folder.path());
    const gl::ShaderSource first = shaders.source();
    CHECK(first("draw/sky.frag") == "one");
    CHECK_FALSE(first("draw/gone.frag"));
    CHECK_FALSE(shaders.changed());
    std::ofstream(folder.path() / "draw" / ".sky.frag.swp") << "an editor's";
    CHECK_FALSE(shaders.changed());
    std::ofstream(file) << "two";
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(2));
    CHECK(shaders.changed());
    CHECK_FALSE(shaders.changed());
    CHECK(shaders.source()("draw/sky.frag") == "two");
    CHECK(first("draw/sky.frag") == "one");  // what worked is still to be had
}
