// What scene files set, and how they and material files find one another.
#include "scene/scene.hpp"
#include "files/utf8_path.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "catch.hpp"
#include "core/world.hpp"
#include "support/scene_text.hpp"
#include "support/test_folder.hpp"

using namespace sunder;
using namespace sunder::core;
namespace fs = std::filesystem;

TEST_CASE("A scene file sets everything it names", "[scene]") {
    const scene::Scene scene = scene::parseScene(R"(
title = "Everything"
frames = 1e2
gravity = [1, -2.5, 3]
seed = 42
[solver]
substeps = 20
fracture_interval = 3
[ground]
enabled = false
friction = 0.25
[camera]
position = [1, 2, 3]
target = [0, 1, 0]
field_of_view = 60
[material.mine]
base = "concrete"
density = 2000
[[body]]
name = "wall"
material = "mine"
size = [2, 1, 0.2]
cells = [10, 5, 1]
position = [0, -3, 1]
anchor = ["bottom", "left"]
copies = [2, 1, 3]
spacing = [4, 0, -2]
[[body.region]]
from = [0, 0, 0]
to = [1, 2, 0]
material = "wood"
[[body.region]]
from = [3, 3, 0]
to = [3, 3, 0]
empty = true
[[event]]
time = 0.1
kind = "force"
body = "wall"
point = [0, 1, 0.05]
radius = 0.3
vector = [0, 0, -250]
duration = 0.5
[[event]]
time = 0.2
kind = "velocity"
body = "wall 3"
point = [0, 1, 0.05]
radius = 0.3
vector = [0, 0, -2]
)",
                                                 "folder/all.toml", {});
    CHECK(scene.name == "all");
    CHECK(scene.title == "Everything");
    CHECK(scene.frames == 100);
    CHECK(scene.substeps == 20);
    CHECK(scene.camera.position == Vec3(1, 2, 3));
    CHECK(scene.camera.fieldOfView == 60);
    const WorldDescription& world = scene.world;
    CHECK(world.step == 1.0 / 1200);
    CHECK(world.fractureInterval == 3);
    CHECK(world.gravity == Vec3(1, -2.5, 3));
    CHECK(world.seed == 42);
    CHECK_FALSE(world.ground);
    CHECK(world.groundFriction == 0.25);

    REQUIRE(world.materials.size() == 2);
    CHECK(world.materials[0].name == "mine");
    CHECK(world.materials[0].density == 2000);
    CHECK(world.materials[0].youngModulus == 30e9);
    CHECK(world.materials[1].name == "wood");

    REQUIRE(world.bodies.size() == 6);
    const BodyDescription& third = world.bodies[2];
    CHECK(third.name == "wall 3");
    CHECK(third.position == Vec3(0, -3, -1));
    CHECK(third.cells == IVec3(10, 5, 1));
    CHECK(third.anchors == std::vector<Side>{Side::Bottom, Side::Left});
    REQUIRE(third.regions.size() == 2);
    CHECK(third.regions[0].material == 1);
    CHECK(third.regions[0].to == IVec3(1, 2, 0));
    CHECK(third.regions[1].material == -1);
    CHECK(world.bodies[5].position == Vec3(4, -3, -3));

    REQUIRE(world.events.size() == 7);
    for (int i = 0; i < 6; ++i) CHECK(world.events[i].body == i);
    CHECK(world.events[0].kind == EventDescription::Kind::Force);
    CHECK(world.events[0].duration == 0.5);
    CHECK(world.events[0].where == "folder/all.toml:36: event 1");
    CHECK(world.events[6].body == 2);
    CHECK(world.events[6].kind == EventDescription::Kind::Velocity);
    CHECK(world.events[6].duration == 0.005);
}

TEST_CASE("A body is turned about the world's x axis, then y, then z", "[scene]") {
    const scene::Scene scene = scene::parseScene(
        std::string(kBody) + "position = [1, 2, 3]\nrotation = [90, 0, 90]\n", "walls.toml", {});
    const BodyDescription& body = scene.world.bodies[0];
    CHECK((body.orientation * Vec3(0, 1, 0) - Vec3(0, 0, 1)).norm() < 1e-15);
    CHECK((body.orientation * Vec3(0, 0, 1) - Vec3(1, 0, 0)).norm() < 1e-15);
    CHECK(body.position == Vec3(1, 2, 3));
    // Turned copies may stand nearer to each other than their width: World sees whether they fit.
    const scene::Scene rows = scene::parseScene(
        std::string(kBody) + "rotation = [0, 90, 0]\ncopies = [3, 1, 1]\nspacing = [0.9, 0, 0]\n",
        "walls.toml", {});
    CHECK(rows.world.bodies.size() == 3);
    CHECK(rows.world.bodies[2].orientation.coeffs() == rows.world.bodies[0].orientation.coeffs());
}

TEST_CASE("A scene needs no more than one body", "[scene]") {
    const scene::Scene scene = scene::parseScene(kBody, "walls.toml", {});
    CHECK(scene.title == "walls");
    CHECK(scene.frames == 120);
    CHECK(scene.world.step == 1.0 / 3000);
    CHECK(scene.world.ground);
    REQUIRE(scene.world.bodies.size() == 1);
    CHECK(scene.world.bodies[0].name == "wall");
    CHECK(scene.world.bodies[0].anchors.empty());
    CHECK(scene.world.events.empty());
}

TEST_CASE("A room has the ground's friction and no ceiling unless it says so", "[scene]") {
    const std::string walls = "[room]\nx = [-1.5, 2]\nz = [-0.05, 3]\n";
    const scene::Scene scene =
        scene::parseScene("[ground]\nfriction = 0.3\n" + walls + kBody, "walls.toml", {});
    REQUIRE(scene.world.room);
    CHECK(scene.world.room->x == std::array{-1.5, 2.0});
    CHECK(scene.world.room->z == std::array{-0.05, 3.0});
    CHECK(scene.world.room->friction == 0.3);
    CHECK(!scene.world.room->ceiling);
    const scene::Scene high =
        scene::parseScene(walls + "friction = 0.7\nceiling = 2\n" + kBody, "walls.toml", {});
    CHECK(high.world.room->friction == 0.7);
    CHECK(high.world.room->ceiling == 2.0);
}

TEST_CASE("Scene and material files are read from disk, relative to one another", "[scene]") {
    const TestFolder folder;
    const auto write = [&](const fs::path& name, const std::string& text) {
        fs::create_directories((folder.path() / name).parent_path());
        std::ofstream(folder.path() / name, std::ios::binary) << text;
        return files::utf8FromPath(folder.path() / name);
    };
    write("stuff/heavy.toml", "base = '../light.toml'\ndensity = 5000\n");
    write("light.toml", "base = 'rubber'\nspread = 0.5\n");
    const std::string path = write("test.toml", replaced(kBody, "'wood'", "'stuff/heavy.toml'"));
    const scene::Scene scene = scene::loadScene(path);
    CHECK(scene.name == "test");
    REQUIRE(scene.world.materials.size() == 1);
    CHECK(scene.world.materials[0].name == "heavy");
    CHECK(scene.world.materials[0].density == 5000);
    CHECK(scene.world.materials[0].spread == 0.5);
    CHECK(scene.world.materials[0].youngModulus == 10e6);
    CHECK(scene::loadMaterial("stuff/heavy.toml", folder.path()).density == 5000);

    SECTION("a mistake names the material's own file and line") {
        write("stuff/heavy.toml", "\n\ndensity = 0\n");
        checkParts(messageOf([&] { scene::loadScene(path); }),
                   {"heavy.toml:3: density must be", "not 0"});
    }
    SECTION("a circle of files ends") {
        write("light.toml", "base = 'stuff/heavy.toml'\n");
        checkParts(messageOf([&] { scene::loadScene(path); }), {".toml:1: ", "circle"});
    }
    SECTION("what cannot be read is named") {
        checkParts(
            messageOf([&] { scene::loadScene(files::utf8FromPath(folder.path() / "no.toml")); }),
            {"cannot read '", "No such file"});
        checkParts(messageOf([&] { scene::loadScene(files::utf8FromPath(folder.path())); }),
                   {"cannot read '", "it is a folder"});
        const std::string large = write("large.toml", std::string((4u << 20) + 1, '\n'));
        checkParts(messageOf([&] { scene::loadScene(large); }),
                   {"cannot read '", "larger than 4 MiB"});
    }
}
