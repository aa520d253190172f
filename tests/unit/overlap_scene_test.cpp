// Overlaps in scene files: what says that they are allowed, and what those that are not are
// answered with.
#include "catch.hpp"
#include "scene/scene.hpp"
#include "scene/scene_writer.hpp"
#include "support/scene_text.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

const std::string kBall = "[[object]]\nname = 'ball'\nshape = 'sphere'\nradius = 0.2\nmass = 5\n";
const std::string kRoom = "[room]\nx = [-2, 2]\nz = [-1, 1]\n";
const std::string kAllow = "overlap = 'allow'\n";

std::string worldError(const std::string& text) {
    return messageOf([&] { const World world(scene::parseScene(text, "walls.toml", {}).world); });
}

}  // namespace

TEST_CASE("An overlap in a scene is refused with file, line and field", "[scene]") {
    const std::string second = replaced(kBody, "'wall'", "'other'");
    const std::vector<Bad> cases{
        {kBody + "position = [0, -1, 0]\n",
         {"walls.toml:6: body 1: position: body 'wall' reaches 1 m below the ground at y = 0 when "
          "the world begins; move it, or give it overlap = \"allow\""}},
        {kBody + "copies = [1, 2, 1]\nspacing = [0, -2, 0]\n",
         {"walls.toml:1: body 1: position: body 'wall 2' reaches 2 m below the ground"}},
        {kBody + "position = [1, 0, 0]\n" + kRoom,
         {"walls.toml:6: body 1: position: body 'wall' reaches 0.5 m beyond the room's wall at x = "
          "2 m"}},
        {kBody + "copies = [1, 1, 3]\nspacing = [0, 0, 0.5]\n" + kRoom,
         {"walls.toml:1: body 1: position: body 'wall 3' reaches 0.05 m beyond the room's wall at "
          "z = 1 m"}},
        {kBody + kRoom + "ceiling = 1.5\n",
         {"body 1: position: body 'wall' reaches 0.5 m above the room's ceiling at 1.5 m"}},
        {kBody + second + "position = [2.9, 0, 0.05]\n",
         {"walls.toml:11: body 2: position: body 'other' and body 'wall' overlap by 0.05 m when "
          "the "
          "world begins; move one of them, or give one overlap = \"allow\""}},
        {kBody + kBall + "position = [0, 1, 0.2]\n",
         {"walls.toml:11: object 1: position: object 'ball' and body 'wall' overlap by 0.05 m"}},
        {kBody + kBall + "position = [0, -3, 2]\n",
         {"walls.toml:11: object 1: position: object 'ball' reaches 3.2 m below the ground"}},
        {kBody + kBall + "position = [0, 1, 1]\n" + replaced(kBall, "'ball'", "'egg'") +
             "position = [0, 1, 1.3]\n",
         {"walls.toml:17: object 2: position: object 'egg' and object 'ball' overlap by 0.1 m"}},
        {kBody + kBall + "position = [3, 1, 0]\n" + kRoom,
         {"walls.toml:11: object 1: position: object 'ball' reaches 1.2 m beyond the room's wall "
          "at "
          "x = 2 m"}},
    };
    for (const Bad& bad : cases) {
        INFO("input: " << bad.text);
        checkParts(worldError(bad.text), bad.parts);
        // All of it is allowed where it is marked.
        CHECK(
            worldError(replaced(bad.text, "name = 'wall'\n", "name = 'wall'\n" + kAllow)).empty() ==
            (bad.text.find("'ball'") == std::string::npos ||
             bad.text.find("[0, 1, 0.2]") != std::string::npos));
        if (bad.text.find("'ball'") == std::string::npos) continue;
        CHECK(
            worldError(replaced(bad.text, "name = 'ball'\n", "name = 'ball'\n" + kAllow)).empty());
    }
    CHECK(worldError(kBody + "position = [0, -1, 0]\n[ground]\nenabled = false\n").empty());
    CHECK(!worldError(kBody + kBody).empty());
    CHECK(worldError("[contact]\nenabled = false\n" + kBody + second).empty());
}

TEST_CASE("Whether things may overlap, and how fast they part, is read and written", "[scene]") {
    const scene::Scene plain = scene::parseScene(kBody + kBall, "walls.toml", {});
    CHECK(!plain.world.bodies[0].mayOverlap);
    CHECK(!plain.world.objects[0].mayOverlap);
    CHECK(plain.world.partingSpeed == 1);
    CHECK(!scene::parseScene(kBody + "overlap = 'refuse'\n", "walls.toml", {})
               .world.bodies[0]
               .mayOverlap);
    // Copies in each other, too.
    const scene::Scene marked =
        scene::parseScene("[contact]\nparting_speed = 0.25\n" + kBody + kAllow +
                              "copies = [2, 1, 1]\nspacing = [1, 0, 0]\n" + kBall + kAllow,
                          "walls.toml", {});
    const std::string text = scene::writeScene(marked);
    for (const scene::Scene& scene : {marked, scene::parseScene(text, "walls.toml", {})}) {
        CHECK(scene.world.bodies[0].mayOverlap);
        CHECK(scene.world.bodies[1].mayOverlap);
        CHECK(scene.world.objects[0].mayOverlap);
        CHECK(scene.world.partingSpeed == 0.25);
        CHECK(World(scene.world).partings().size() == 1);
        CHECK(scene::writeScene(scene) == text);
    }
    const std::vector<Bad> cases{
        {kBody + "overlap = true\n",
         {"walls.toml:6: body 1: overlap must be one of refuse, allow, not true"}},
        {kBody + kBall + "overlap = 'alow'\n",
         {"walls.toml:11: object 1: overlap must be one of refuse, allow, not the text 'alow'",
          "did you mean 'allow'?"}},
        {"[contact]\nparting_speed = 0\n" + kBody,
         {"walls.toml:2: contact: parting_speed must be from 0.2 to 100 m/s, not 0"}},
    };
    for (const Bad& bad : cases) {
        INFO("input: " << bad.text);
        checkParts(sceneError(bad.text), bad.parts);
    }
}
