#include "scene/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "catch.hpp"
#include "core/world.hpp"

using namespace sunder;

namespace {

/// The message of the InputError that `action` throws; empty when it throws none.
std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

std::string sceneError(const std::string& text) {
    return messageOf([&] { parseScene(text, "walls.toml", {}); });
}

std::string materialError(const std::string& text) {
    return messageOf([&] { parseMaterial(text, "stuff.toml"); });
}

void checkParts(const std::string& message, const std::vector<std::string>& parts) {
    INFO("message: " << message);
    for (const std::string& part : parts) {
        INFO("wanted: " << part);
        CHECK(message.find(part) != std::string::npos);
    }
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.size() < 1500);
}

struct Bad {
    std::string text;
    std::vector<std::string> parts;
};

/// Lines 1 to 5 of a scene; tests add line 6 and on.
const std::string kBody =
    "[[body]]\nname = 'wall'\nmaterial = 'wood'\nsize = [3, 2, 0.1]\ncells = [30, 20, 1]\n";
/// The same with an event on lines 6 to 12; tests add line 13 and on.
const std::string kEvent = kBody +
                           "[[event]]\ntime = 0.1\nkind = 'impulse'\nbody = 'wall'\n"
                           "point = [0, 1, 0]\nradius = 0.3\nvector = [0, 0, -1]\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

/// A folder of its own that disappears with the test.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        const auto base = std::filesystem::temp_directory_path();
        for (int i = 0; path_.empty(); ++i) {
            const auto candidate = base / ("sunder_scene_test_" + std::to_string(i));
            if (std::filesystem::create_directory(candidate)) path_ = candidate;
        }
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << text;
        return (path_ / name).string();
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace

TEST_CASE("A scene file sets everything it names", "[scene]") {
    const Scene scene = parseScene(R"(
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

TEST_CASE("A scene needs no more than one body", "[scene]") {
    const Scene scene = parseScene(kBody, "walls.toml", {});
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
    const Scene scene = parseScene("[ground]\nfriction = 0.3\n" + walls + kBody, "walls.toml", {});
    REQUIRE(scene.world.room);
    CHECK(scene.world.room->x == std::array{-1.5, 2.0});
    CHECK(scene.world.room->z == std::array{-0.05, 3.0});
    CHECK(scene.world.room->friction == 0.3);
    CHECK(!scene.world.room->ceiling);
    const Scene high =
        parseScene(walls + "friction = 0.7\nceiling = 2\n" + kBody, "walls.toml", {});
    CHECK(high.world.room->friction == 0.7);
    CHECK(high.world.room->ceiling == 2.0);
}

TEST_CASE("A mistake in a scene becomes one sentence", "[scene]") {
    const std::vector<Bad> cases{
        // Not TOML, or not a scene.
        {"frames = 120\nframes = [1", {"walls.toml:2: not valid TOML: "}},
        {"title = 'a'\ntitle = 'b'\n", {"walls.toml:2: not valid TOML: "}},
        {"title = '\xff'\n", {"walls.toml:1: not valid TOML: "}},
        {"", {"walls.toml: the scene has no body", "[[body]]"}},
        {"frames = 3\n", {"walls.toml: the scene has no body"}},
        // Unknown keys, at every level.
        {"\n\nfrmaes = 3\n",
         {"walls.toml:3: unknown key 'frmaes' in the scene; did you mean 'frames'? (known: title, "
          "frames,"}},
        {"[solver]\nsteps = 3\n", {"walls.toml:2: unknown key 'steps' in solver", "substeps"}},
        {"[ground]\nfricton = 3\n", {"walls.toml:2: unknown key", "did you mean 'friction'?"}},
        {"[camera]\nfov = 3\n", {"walls.toml:2: unknown key 'fov' in camera", "field_of_view"}},
        {"[material.x]\nyoungs_modulus = 3\n",
         {"walls.toml:2: unknown key 'youngs_modulus' in material 'x'",
          "did you mean 'young_modulus'?"}},
        {kBody + "sise = 3\n",
         {"walls.toml:6: unknown key 'sise' in body 1; did you mean 'size'?"}},
        {kBody + "[[body.region]]\nfrom = [0,0,0]\nuntil = 1\n",
         {"walls.toml:8: unknown key 'until' in region 1 of body 1"}},
        {kEvent + "force = 1\n", {"walls.toml:13: unknown key 'force' in event 1"}},
        // A misspelt key is the mistake, not the missing one.
        {"[[body]]\nname = 'a'\nmaterial = 'wood'\nsice = [1,1,1]\ncells = [1,1,1]\n",
         {"walls.toml:4: unknown key 'sice'", "did you mean 'size'?"}},
        // Scene-wide numbers.
        {"frames = 0\n" + kBody,
         {"walls.toml:1: frames must be a whole number from 1 to 1000000, not 0"}},
        {"frames = 1.5\n" + kBody, {"walls.toml:1: frames must be a whole number", "not 1.5"}},
        {"frames = nan\n" + kBody, {"walls.toml:1: frames must be a whole number", "not nan"}},
        {"frames = '9'\n" + kBody, {"frames must be a whole number", "not the text '9'"}},
        {"frames = 1979-05-27\n" + kBody, {"walls.toml:1: frames", "not a date or time"}},
        {"seed = -1\n" + kBody, {"walls.toml:1: seed must be a whole number from 0", "not -1"}},
        {"title = 3\n" + kBody, {"walls.toml:1: title must be a text in quotes, not 3"}},
        {"title = \"a\\nb\"\n" + kBody, {"walls.toml:1: title must be one line", "'a\\nb'"}},
        {"title = '" + std::string(5000, 'x') + "'\n" + kBody,
         {"walls.toml:1: title must be at most 200 characters long", "xxx…"}},
        {"gravity = -9.81\n" + kBody,
         {"walls.toml:1: gravity must be a list of three numbers, not -9.81"}},
        {"gravity = [0, -9.81]\n" + kBody,
         {"walls.toml:1: gravity must be a list of three", "a list of 2"}},
        {"gravity = [0,\n 'x', 0]\n" + kBody,
         {"walls.toml:2: gravity: number 2 must be a number from -1000 to 1000 m/s²", "'x'"}},
        {"gravity = [0, inf, 0]\n" + kBody, {"walls.toml:1: gravity: number 2", "not inf"}},
        {"solver = 3\n" + kBody,
         {"walls.toml:1: solver must be one table, headed [solver], not 3"}},
        {"[solver]\nsubsteps = 0\n" + kBody,
         {"walls.toml:2: solver: substeps must be a whole number from 1 to 10000, not 0"}},
        {"[solver]\nfracture_interval = 101\n" + kBody,
         {"walls.toml:2: solver: fracture_interval", "101"}},
        {"[ground]\nenabled = 1\n" + kBody,
         {"walls.toml:2: ground: enabled must be true or false, not 1"}},
        {"[ground]\nfriction = -0.1\n" + kBody,
         {"walls.toml:2: ground: friction must be from 0 to 10, not -0.1"}},
        {"[room]\nx = [-2, 2]\n" + kBody,
         {"walls.toml:1: room: z is missing; give [low, high] in m, where the walls stand"}},
        {"[room]\nx = [-2, 0, 2]\n" + kBody,
         {"walls.toml:2: room: x must be a list of two numbers"}},
        {"[room]\nx = [2, -2]\nz = [-1, 1]\n" + kBody,
         {"walls.toml:2: room: x: number 2 must be greater than number 1, 2, not -2"}},
        {"[room]\nx = [-2, 2]\nz = [-1, 1e5]\n" + kBody,
         {"walls.toml:3: room: z: number 2 must be from -10000 to 10000 m, not 100000"}},
        {"[room]\nx = [-2, 2]\nz = [-1, 1]\nfriction = 11\n" + kBody,
         {"walls.toml:4: room: friction must be from 0 to 10, not 11"}},
        {"[room]\nx = [-2, 2]\nz = [-1, 1]\nceiling = 0\n" + kBody,
         {"walls.toml:4: room: ceiling must be", "not 0"}},
        {"[room]\nx = [-2, 2]\nz = [-1, 1]\nheight = 3\n" + kBody,
         {"walls.toml:4: unknown key 'height' in room", "known: x, z, friction, ceiling"}},
        {kBody + "position = [1, 0, 0]\n[room]\nx = [-2, 2]\nz = [-1, 1]\n",
         {"walls.toml:6: body 1: position: number 1 of body 'wall' must be from -0.5 to 0.5 m, "
          "not 1, to be inside the room, whose walls stand at x = -2 and 2 m"}},
        {kBody + "copies = [1, 1, 3]\nspacing = [0, 0, 0.5]\n[room]\nx = [-2, 2]\nz = [-1, 1]\n",
         {"walls.toml:1: body 1: position: number 3 of body 'wall 3' must be from -0.95 to 0.95 m, "
          "not 1"}},
        {kBody + "[room]\nx = [-1, 1]\nz = [-1, 1]\n",
         {"walls.toml:4: body 1: size: body 'wall' is too large for the room, whose walls stand at "
          "x = -1 and 1 m; make it smaller or the room larger"}},
        {kBody + "[room]\nx = [-2, 2]\nz = [-1, 1]\nceiling = 1.5\n",
         {"walls.toml:1: body 1: position: body 'wall' reaches up to 2 m, through the ceiling at "
          "1.5 m; lower it or raise ceiling in [room]"}},
        {"[camera]\nposition = [1,1,1]\ntarget = [1,1,1]\n" + kBody,
         {"walls.toml:2: camera: position and target"}},
        {"[camera]\nfield_of_view = 171\n" + kBody,
         {"walls.toml:2: camera: field_of_view must be from 1 to 170 degrees, not 171"}},
        // Bodies.
        {"[body]\nname = 'a'\n",
         {"walls.toml:1: body must be a list of tables, each headed [[body]], not a table"}},
        {"body = [1]\n", {"walls.toml:1: each body must be a table, headed [[body]], not 1"}},
        {"\n[[body]]\nmaterial = 'wood'\n", {"walls.toml:2: body 1: name is missing"}},
        {"[[body]]\nname = 'a'\nmaterial = 'wood'\ncells = [1,1,1]\n",
         {"walls.toml:1: body 1: size is missing; give [x, y, z] in m"}},
        {replaced(kBody, "[3, 2, 0.1]", "[3, 2, 0]"),
         {"walls.toml:4: body 1: size: number 3 must be from 0.001 to 1000 m, not 0"}},
        {replaced(kBody, "[30, 20, 1]", "[30, 0, 1]"),
         {"walls.toml:5: body 1: cells: number 2 must be a whole number from 1", "not 0"}},
        {replaced(kBody, "[30, 20, 1]", "[30, -20, 1]"),
         {"walls.toml:5: body 1: cells: number 2", "not -20"}},
        {replaced(kBody, "[30, 20, 1]", "[]"),
         {"walls.toml:5: body 1: cells must be a list of three", "list of 0"}},
        {replaced(kBody, "[30, 20, 1]", "[4096, 4096, 2]"),
         {"walls.toml:5: body 1: the scene has too many cells", "16777216"}},
        {replaced(kBody, "[30, 20, 1]", "[16777216, 16777216, 16777216]"),
         {"walls.toml:5: body 1: the scene has too many cells"}},
        {replaced(kBody, "'wall'", "''"), {"walls.toml:2: body 1: name must not be empty"}},
        {replaced(kBody, "'wall'", "\"\\u001b[2J\""),
         {"walls.toml:2: body 1: name must be one line", "'\\u001b[2J'"}},
        {kBody + "position = [0, -1, 0]\n",
         {"walls.toml:6: body 1: position: number 2", "at least 0 m, not -1",
          "enabled = false in [ground]"}},
        {kBody + "anchor = 'bottom'\n",
         {"walls.toml:6: body 1: anchor must be a list", "not the text 'bottom'"}},
        {kBody + "anchor = ['botom']\n",
         {"walls.toml:6: body 1: each of anchor must be one of left, right, bottom, top, back, "
          "front",
          "did you mean 'bottom'?"}},
        {kBody + "anchor = ['top', 'top']\n", {"walls.toml:6: body 1: anchor names 'top' twice"}},
        {kBody + kBody, {"walls.toml:7: body 2: there is already a body named 'wall'"}},
        {replaced(kBody, "'wood'", "'wod'"),
         {"walls.toml:3: body 1: material 'wod' is neither a preset nor a file; presets: ",
          "; did you mean 'wood'?", "concrete"}},
        {"[material.mine]\n" + replaced(kBody, "'wood'", "'nine'"),
         {"walls.toml:4: body 1: material 'nine'", "this scene's own: mine",
          "did you mean 'mine'?"}},
        {replaced(kBody, "'wood'", "'nowhere/x.toml'"),
         {"walls.toml:3: body 1: cannot read 'nowhere/x.toml': ", "No such file"}},
        {kBody + "copies = [0, 1, 1]\n",
         {"walls.toml:6: body 1: copies: number 1 must be a whole number from 1"}},
        {kBody + "copies = [2, 1, 1]\n", {"walls.toml:6: body 1: copies needs spacing"}},
        {kBody + "copies = [2, 1, 1]\nspacing = [1, 0, 0]\n",
         {"walls.toml:7: body 1: spacing: number 1 must be at least the body's size, 3 m",
          "not 1"}},
        {kBody + "copies = [1, 2, 1]\nspacing = [0, -2, 0]\n",
         {"walls.toml:7: body 1: spacing: number 2", "below the ground"}},
        {kBody + "copies = [9999, 9999, 9999]\nspacing = [9, 9, 9]\n",
         {"walls.toml:6: body 1: the scene has too many bodies", "at most 10000"}},
        {kBody + "copies = [2, 1, 1]\nspacing = [4, 0, 0]\n" +
             replaced(kBody, "'wall'", "'wall 2'"),
         {"walls.toml:9: body 2: there is already a body named 'wall 2'"}},
        // Regions.
        {kBody + "[[body.region]]\nto = [1,1,0]\nempty = true\n",
         {"walls.toml:6: region 1 of body 1: from is missing"}},
        {kBody + "[[body.region]]\nfrom = [0,20,0]\nto = [0,20,0]\nempty = true\n",
         {"walls.toml:7: region 1 of body 1: from: number 2 must be at most 19, not 20",
          "[30, 20, 1] cells"}},
        {kBody + "[[body.region]]\nfrom = [2,0,0]\nto = [1,0,0]\nempty = true\n",
         {"walls.toml:8: region 1 of body 1: to: number 1 must be from 2 (that of from) to 29, not "
          "1"}},
        {kBody + "[[body.region]]\nfrom = [-1,0,0]\nto = [1,0,0]\nempty = true\n",
         {"walls.toml:7: region 1 of body 1: from: number 1", "not -1"}},
        {kBody + "[[body.region]]\nfrom = [0,0,0]\nto = [1,0,0]\n",
         {"walls.toml:6: region 1 of body 1: it has no material", "empty = true"}},
        {kBody + "[[body.region]]\nfrom = [0,0,0]\nto = [1,0,0]\nempty = true\nmaterial = 'wood'\n",
         {"walls.toml:6: region 1 of body 1: it has both a material and empty = true"}},
        {kBody + "region = 1\n",
         {"walls.toml:6: body 1: region must be a list of tables, each headed [[body.region]], not "
          "1"}},
        // Events.
        {replaced(kEvent, "body = 'wall'", "body = 'wal'"),
         {"walls.toml:9: event 1: there is no body 'wal'; bodies: wall; did you mean 'wall'?"}},
        {replaced(kEvent, "'impulse'", "'push'"),
         {"walls.toml:8: event 1: kind must be one of impulse, force, velocity, throw, not the "
          "text 'push'"}},
        {replaced(kEvent, "'impulse'", "'force'"),
         {"walls.toml:6: event 1: duration is missing; give how long the force acts, in s"}},
        {replaced(kEvent, "radius = 0.3", "radius = 0"),
         {"walls.toml:11: event 1: radius must be greater than 0 and at most 10000 m, not 0"}},
        {replaced(kEvent, "time = 0.1", "time = -0.1"),
         {"walls.toml:7: event 1: time must be from 0", "not -0.1"}},
        {replaced(kEvent, "[0, 0, -1]", "[0, 0, nan]"),
         {"walls.toml:12: event 1: vector: number 3", "N·s, not nan"}},
        {kEvent + "duration = 0\n", {"walls.toml:13: event 1: duration must be greater than 0"}},
        {replaced(kEvent, "point = [0, 1, 0]\n", ""),
         {"walls.toml:6: event 1: point is missing; give [x, y, z] in m"}},
        // Materials of the scene.
        {"material = 'wood'\n" + kBody,
         {"walls.toml:1: material must be tables, each headed [material.NAME]"}},
        {"[material]\nx = 1\n" + kBody, {"walls.toml:2: material 'x' must be a table"}},
        {"[material.x]\nbase = 'wod'\n" + kBody,
         {"walls.toml:2: material 'x': material 'wod' is neither", "'wood'?"}},
        {"[material.x]\nbase = 'x'\n" + kBody,
         {"walls.toml:2: material 'x': material 'x' is neither"}},
        {"[material.x]\nbase = 'y'\n[material.y]\nbase = 'x'\n" + kBody,
         {"walls.toml:4: material 'y': base 'x' leads back"}},
        {"[material.'a/b']\n" + kBody, {"walls.toml:1: material 'a/b': a material's name must be"}},
        {"[material.x]\ndensity = -5\n" + kBody,
         {"walls.toml:2: material 'x': density must be", "kg/m³, not -5"}},
    };
    for (const Bad& bad : cases) {
        INFO("input: " << bad.text.substr(0, 400));
        checkParts(sceneError(bad.text), bad.parts);
    }
}

TEST_CASE("A mistake in a material becomes one sentence", "[scene]") {
    const std::vector<Bad> cases{
        {"poisson_ratio = 0.5\n",
         {"stuff.toml:1: poisson_ratio must be at least 0 and less than 0.5, not 0.5"}},
        {"poisson_ratio = -0.1\n",
         {"stuff.toml:1: poisson_ratio must be at least 0 and less than 0.5"}},
        {"\nyoung_modulus = 0\n", {"stuff.toml:2: young_modulus must be from 1 to 1e12 Pa, not 0"}},
        {"density = inf\n", {"stuff.toml:1: density must be", "not inf"}},
        {"density = -nan\n", {"stuff.toml:1: density must be", "nan"}},
        {"density = true\n", {"stuff.toml:1: density must be a number from", "not true"}},
        {"density = {a = 1}\n", {"stuff.toml:1: density must be a number from", "not a table"}},
        {"max_stress = 0\n",
         {"stuff.toml:1: max_stress must be greater than 0 and at most 1e15 Pa, not 0"}},
        {"strength = [1, 2]\n",
         {"stuff.toml:1: strength must be a list of three numbers, or one number", "list of 2"}},
        {"strength = 0\n", {"stuff.toml:1: strength must be greater than 0"}},
        {"strength = [1, 1, -1]\n",
         {"stuff.toml:1: strength: number 3 must be greater than 0", "not -1"}},
        {"law = 'hooke'\n",
         {"stuff.toml:1: law must be one of green, corotated, not the text 'hooke'"}},
        {"fracture = 'bonds'\n",
         {"stuff.toml:1: fracture must be one of none, cell, bond", "did you mean 'bond'?"}},
        {"avg_display_section_width = -0.1\n",
         {"stuff.toml:1: avg_display_section_width must be from 0.001 to 100 m, not -0.1"}},
        {"horiz_edge_frequency = 21\n",
         {"stuff.toml:1: horiz_edge_frequency must be from 0 to 20, not 21"}},
        {"vert_edge_amplitude = nan\n",
         {"stuff.toml:1: vert_edge_amplitude must be from 0 to 100 m, not nan"}},
        {"surface = 'wod'\n", {"stuff.toml:1: surface", "'wod'", "wood"}},
        {"clusters = 3\n",
         {"stuff.toml:1: clusters must be one of none, voronoi, running-bond, planks, not 3"}},
        {"colour = [0, 0, 1.1]\n", {"stuff.toml:1: colour: number 3 must be from 0 to 1, not 1.1"}},
        {"color = [0, 0, 1]\n",
         {"stuff.toml:1: unknown key 'color' in the material; did you mean 'colour'?"}},
        {"title = 'x'\n", {"stuff.toml:1: unknown key 'title' in the material"}},
    };
    for (const Bad& bad : cases) {
        INFO("input: " << bad.text);
        checkParts(materialError(bad.text), bad.parts);
    }
}

TEST_CASE("Every number of a material is checked against its range", "[scene]") {
    for (const MaterialField& field : materialFields()) {
        const std::string key(field.key);
        INFO(key);
        const auto assignment = [&](double value) {
            return key + " = " + std::to_string(value) + "\n";
        };
        CHECK(materialError(assignment(field.min - 1)).starts_with("stuff.toml:1: " + key));
        CHECK(materialError(key + " = 1e300").starts_with("stuff.toml:1: " + key));
        CHECK(materialError(key + " = nan").starts_with("stuff.toml:1: " + key));
        CHECK(materialError(assignment(field.min)).empty() == !field.minExcluded);
        CHECK(materialError(assignment(field.max)).empty() == !field.maxExcluded);
        // A value inside the range ends in the right field.
        const double inside = field.min + 0.25 * (field.max - field.min);
        const Material m = parseMaterial(assignment(inside), "stuff.toml");
        if (field.scalar)
            CHECK(m.*field.scalar == Approx(inside));
        else
            CHECK((m.*field.vector).isApprox(Vec3::Constant(inside)));
    }
}

TEST_CASE("Boundary strength follows strength until it has a value of its own", "[scene]") {
    const Material plain = parseMaterial("strength = [1, 2, 3]", "m.toml");
    CHECK(plain.strength == Vec3(1, 2, 3));
    CHECK(plain.boundaryStrength == Vec3(1, 2, 3));
    const Material both = parseMaterial("strength = 5\nboundary_strength = [1, 2, 3]", "m.toml");
    CHECK(both.strength == Vec3(5, 5, 5));
    CHECK(both.boundaryStrength == Vec3(1, 2, 3));
    // Concrete's chunks keep their weak boundaries.
    const Material base = parseMaterial("base = 'concrete'\nstrength = 20e6", "m.toml");
    CHECK(base.strength == Vec3(20e6, 20e6, 20e6));
    CHECK(base.boundaryStrength == Vec3(5.6e6, 5.6e6, 5.6e6));
}

TEST_CASE("Materials build on one another", "[scene]") {
    // Written in an order in which each base comes after its user; `wood` builds on the preset it
    // hides.
    const Scene scene = parseScene(
        "[material.a]\nbase = 'z'\ndensity = 7\n"
        "[material.z]\nbase = 'wood'\nspread = 0.1\n"
        "[material.wood]\nbase = 'wood'\ndamping = 9\n" +
            replaced(kBody, "'wood'", "'a'"),
        "walls.toml", {});
    REQUIRE(scene.world.materials.size() == 1);
    const Material& a = scene.world.materials[0];
    CHECK(a.name == "a");
    CHECK(a.density == 7);
    CHECK(a.spread == 0.1);
    CHECK(a.damping == 9);
    CHECK(a.noiseAmplitude == 0.48);
}

TEST_CASE("Scene and material files are read from disk, relative to one another", "[scene]") {
    const TemporaryFolder folder;
    folder.write("stuff/heavy.toml", "base = '../light.toml'\ndensity = 5000\n");
    folder.write("light.toml", "base = 'rubber'\nspread = 0.5\n");
    const std::string path =
        folder.write("test.toml", replaced(kBody, "'wood'", "'stuff/heavy.toml'"));
    const Scene scene = loadScene(path);
    CHECK(scene.name == "test");
    REQUIRE(scene.world.materials.size() == 1);
    CHECK(scene.world.materials[0].name == "heavy");
    CHECK(scene.world.materials[0].density == 5000);
    CHECK(scene.world.materials[0].spread == 0.5);
    CHECK(scene.world.materials[0].youngModulus == 10e6);
    CHECK(loadMaterial("stuff/heavy.toml", folder.path()).density == 5000);

    SECTION("a mistake names the material's own file and line") {
        folder.write("stuff/heavy.toml", "\n\ndensity = 0\n");
        checkParts(messageOf([&] { loadScene(path); }), {"heavy.toml:3: density must be", "not 0"});
    }
    SECTION("a circle of files ends") {
        folder.write("light.toml", "base = 'stuff/heavy.toml'\n");
        checkParts(messageOf([&] { loadScene(path); }), {".toml:1: ", "circle"});
    }
    SECTION("what cannot be read is named") {
        checkParts(messageOf([&] { loadScene((folder.path() / "no.toml").string()); }),
                   {"cannot read '", "No such file"});
        checkParts(messageOf([&] { loadScene(folder.path().string()); }),
                   {"cannot read '", "it is a folder"});
        const std::string large = folder.write("large.toml", std::string((4u << 20) + 1, '\n'));
        checkParts(messageOf([&] { loadScene(large); }), {"cannot read '", "larger than 4 MiB"});
    }
}

TEST_CASE("A name that leads nowhere lists the presets", "[scene]") {
    checkParts(messageOf([] { loadScene("wod"); }),
               {"scene 'wod' is neither a preset nor a file; presets: ", "cantilever, concrete, ",
                "; did you mean 'wood'?"});
    checkParts(messageOf([] { loadScene(""); }), {"scene '' is neither"});
    checkParts(messageOf([] { loadScene("a\x1b[31m\nb\xff\u202e"); }),
               {R"('a\u001b[31m\nb\xff\u202e')"});
    checkParts(messageOf([] { loadScene(std::string(100000, 'a')); }), {"aaa…' is neither"});
    checkParts(messageOf([] { loadMaterial("wod"); }),
               {"material 'wod' is neither a preset nor a file", "wood-thesis"});
}

TEST_CASE("Hostile files end in a sentence", "[scene]") {
    std::string dots = "a";
    for (int i = 0; i < 1000000; ++i) dots += ".a";
    checkParts(sceneError(dots + " = 1"), {"walls.toml:1: a key has too many parts"});
    checkParts(sceneError("\n[" + dots + "]"), {"walls.toml:2: a key has too many parts"});
    checkParts(sceneError("x = " + std::string(1000000, '[')), {"walls.toml:1: not valid TOML: "});
    checkParts(sceneError(std::string(5u << 20, ' ')),
               {"walls.toml: the text is larger than 4 MiB"});
    std::string many;
    for (int i = 0; i < 10001; ++i) many += "[[body]]\n";
    checkParts(sceneError(many), {"there are 10001 tables [[body]]; at most 10000 are allowed"});
    // Dots in texts and comments are no keys.
    const std::string stops(40, '.');
    CHECK(sceneError("title = \"\\\"" + stops + "\" # " + stops + "\n" + kBody).empty());
    CHECK(sceneError("title = '''" + stops + "'''\n" + kBody).empty());
}
