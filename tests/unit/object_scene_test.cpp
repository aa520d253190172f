// Objects and throws in scene files: what they set, and what a mistake is answered with.
#include <cmath>
#include <string>
#include <vector>

#include "catch.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

const std::string kSphere = "[[object]]\nname = 'ball'\nshape = 'sphere'\nradius = 0.2\n";
const std::string kBox = "[[object]]\nname = 'crate'\nshape = 'box'\nsize = [1, 2, 3]\n";
const std::string kCapsule =
    "[[object]]\nname = 'log'\nshape = 'capsule'\nradius = 0.2\nlength = 1\n";
const std::string kMass = "mass = 5\n";
const std::string kThrow =
    "[[event]]\nkind = 'throw'\ntime = 0.1\nobject = 'ball'\nfrom = [0, 1, 5]\n"
    "velocity = [0, 0, -20]\n";

scene::Scene parse(const std::string& text) {
    return scene::parseScene(text, "walls.toml", {});
}

std::string without(std::string text, const std::string& line) {
    const auto at = text.find(line);
    REQUIRE(at != std::string::npos);
    return text.erase(at, line.size());
}

}  // namespace

TEST_CASE("Objects and throws set everything they name", "[scene]") {
    const scene::Scene scene =
        parse(kBody + kSphere + R"(mass = 400
position = [1, 2, 3]
rotation = [90, 0, 90]
velocity = [4, 5, 6]
spin = [7, 8, 9]
drag = 0.5
friction = 0.25
restitution = 0.75
colour = [0.1, 0.2, 0.3]
hung_from = [1, 5, 3]
)" + kBox + "fixed = true\nposition = [0, 1, 0]\n" +
              kCapsule + kMass +
              "[[event]]\nkind = 'throw'\ntime = 0.5\nobject = 'log'\n"
              "from = [0, 1, 5]\nvelocity = [0, 0, -20]\nspin = [1, 2, 3]\n");
    REQUIRE(scene.world.objects.size() == 3);
    const ObjectDescription& ball = scene.world.objects[0];
    CHECK(ball.name == "ball");
    CHECK(ball.shape == ObjectShape::Sphere);
    CHECK(ball.halfSize == Vec3(0.2, 0.2, 0.2));
    CHECK(ball.mass == 400);
    CHECK(ball.position.value() == Vec3(1, 2, 3));
    CHECK(ball.velocity == Vec3(4, 5, 6));
    CHECK(ball.spin == Vec3(7, 8, 9));
    CHECK(ball.drag == 0.5);
    CHECK(ball.friction == 0.25);
    CHECK(ball.restitution == 0.75);
    CHECK(ball.colour == Vec3(0.1, 0.2, 0.3));
    CHECK(ball.hungFrom.value() == Vec3(1, 5, 3));
    CHECK_FALSE(ball.fixed);
    // About x, then y, then z: y turns to z and stays there, z to -y and on to x.
    CHECK((ball.orientation * Vec3(0, 1, 0) - Vec3(0, 0, 1)).norm() < 1e-12);
    CHECK((ball.orientation * Vec3(0, 0, 1) - Vec3(1, 0, 0)).norm() < 1e-12);

    const ObjectDescription& crate = scene.world.objects[1];
    CHECK(crate.shape == ObjectShape::Box);
    CHECK(crate.halfSize == Vec3(0.5, 1, 1.5));
    CHECK(crate.fixed);
    CHECK_FALSE(crate.hungFrom);

    const ObjectDescription& log = scene.world.objects[2];
    CHECK(log.shape == ObjectShape::Capsule);
    CHECK(log.halfSize == Vec3(0.2, 0.5, 0.2));
    CHECK_FALSE(log.position);

    REQUIRE(scene.world.throws.size() == 1);
    const ThrowDescription& thrown = scene.world.throws[0];
    CHECK(thrown.time == 0.5);
    CHECK(thrown.object == 2);
    CHECK(thrown.from == Vec3(0, 1, 5));
    CHECK(thrown.velocity == Vec3(0, 0, -20));
    CHECK(thrown.spin == Vec3(1, 2, 3));
    CHECK(scene.world.events.empty());
}

TEST_CASE("Things touch unless the scene says that they do not", "[scene]") {
    CHECK(parse(kBody).world.contact);
    CHECK(parse(kBody + kSphere + kMass).world.contact);
    CHECK_FALSE(parse("[contact]\nenabled = false\n" + kBody).world.contact);
}

TEST_CASE("A mistake in an object or a throw becomes one sentence", "[scene]") {
    const std::string ball = kSphere + kMass;  // lines 6 to 10 behind kBody
    const std::string there = "position = [0, 1, 1]\n";
    const std::string hung = ball + there + "hung_from = [0, 3, 1]\n";
    const std::string fixed = kSphere + "fixed = true\n" + there;
    std::string crowd;
    for (int i = 0; i <= kMaxObjects; ++i) crowd += "[[object]]\n";
    const std::vector<Bad> cases{
        // What it is.
        {kBody + crowd, {"walls.toml:6: there are 251 tables [[object]]; at most 250"}},
        {kBody + ball + "size_of = 1\n", {"walls.toml:11: unknown key 'size_of' in object 1"}},
        {kBody + without(ball, "name = 'ball'\n"),
         {"walls.toml:6: object 1: name is missing; give a name for messages and events"}},
        {kBody + ball + ball,
         {"walls.toml:12: object 2: there is already an object named 'ball'",
          "every object needs a name of its own"}},
        {kBody + without(ball, "shape = 'sphere'\n"),
         {"object 1: shape is missing; give one of sphere, box, capsule"}},
        {kBody + "[[object]]\nname = 'a'\nshape = 'spher'\n",
         {"walls.toml:8: object 1: shape must be one of sphere, box, capsule, not the text "
          "'spher'",
          "did you mean 'sphere'?"}},
        // How large.
        {kBody + without(ball, "radius = 0.2\n"), {"object 1: radius is missing; give in m"}},
        {kBody + ball + "size = [1, 1, 1]\n",
         {"walls.toml:11: object 1: a sphere has no size; give radius"}},
        {kBody + ball + "length = 1\n",
         {"walls.toml:11: object 1: a sphere has no length; give radius"}},
        {kBody + kBox + "radius = 1\n",
         {"walls.toml:10: object 1: a box has no radius; give size"}},
        {kBody + kBox + "length = 1\n",
         {"walls.toml:10: object 1: a box has no length; give size"}},
        {kBody + without(kBox, "size = [1, 2, 3]\n"),
         {"object 1: size is missing; give [x, y, z] in m"}},
        {kBody + kCapsule + "size = [1, 1, 1]\n",
         {"walls.toml:11: object 1: a capsule has no size; give radius and length"}},
        {kBody + without(kCapsule, "length = 1\n"),
         {"object 1: length is missing; give from end to end along its y axis, in m"}},
        {kBody + "[[object]]\nname = 'a'\nshape = 'capsule'\nradius = 0.2\nlength = 0.3\n",
         {"walls.toml:10: object 1: length must be from 0.4 to 2000 m, not 0.3"}},
        {kBody + "[[object]]\nname = 'a'\nshape = 'sphere'\nradius = 0\n",
         {"walls.toml:9: object 1: radius must be from 0.001 to 1000 m, not 0"}},
        {kBody + "[[object]]\nname = 'a'\nshape = 'box'\nsize = [1, 1, 0]\n",
         {"walls.toml:9: object 1: size: number 3 must be from 0.001 to 1000 m, not 0"}},
        // Where it is and how it moves.
        {kBody + kSphere, {"object 1: mass is missing; give in kg, or fixed = true"}},
        {kBody + kSphere + "mass = 0\n",
         {"walls.toml:10: object 1: mass must be from 1e-06 to 1e09 kg, not 0"}},
        {kBody + ball + "rotation = [0, 0, 400]\n",
         {"object 1: rotation: number 3 must be from -360 to 360 degrees, not 400"}},
        {kBody + kSphere + "fixed = true\n",
         {"object 1: position is missing; give [x, y, z] in m, of its centre"}},
        {kBody + fixed + kMass,
         {"walls.toml:12: object 1: a fixed object has no mass; leave it out, or leave fixed out"}},
        {kBody + fixed + "velocity = [1, 0, 0]\n",
         {"12: object 1: a fixed object has no velocity"}},
        {kBody + fixed + "spin = [1, 0, 0]\n", {"12: object 1: a fixed object has no spin"}},
        {kBody + fixed + "hung_from = [1, 0, 0]\n",
         {"12: object 1: a fixed object has no hung_from"}},
        {kBody + fixed + "drag = 1\n", {"12: object 1: a fixed object has no drag"}},
        {kBody + ball + "hung_from = [0, 3, 0]\n",
         {"object 1: position is missing; give", "where it hangs at first"}},
        {kBody + ball + there + "hung_from = [0, 1, 1]\n",
         {"walls.toml:12: object 1: hung_from must be at least 0.001 m from position"}},
        {kBody + ball + "velocity = [1, 0, 0]\n",
         {"walls.toml:11: object 1: an object without position is not there until an event throws "
          "it; give position, or velocity in the event"}},
        {kBody + ball + "spin = [1, 0, 0]\n", {"give position, or spin in the event"}},
        {kBody + ball + there + "velocity = [2e4, 0, 0]\n",
         {"velocity: number 1 must be from -10000 to 10000 m/s, not 20000"}},
        {kBody + ball + "drag = -1\n", {"object 1: drag must be from 0 to 1000 1/s, not -1"}},
        {kBody + ball + "friction = 11\n", {"object 1: friction must be from 0 to 10, not 11"}},
        {kBody + ball + "restitution = 2\n", {"object 1: restitution must be from 0 to 1, not 2"}},
        {kBody + ball + "colour = [0, 2, 0]\n",
         {"object 1: colour: number 2 must be from 0 to 1, not 2"}},
        {"[contact]\nenabled = false\n" + kBody + ball,
         {"walls.toml:2: contact: the scene has objects, which touch nothing without contact; "
          "leave enabled out, or remove the objects"}},
        // Throws, lines 11 to 16 behind kBody and ball.
        {kBody + ball + without(kThrow, "time = 0.1\n"),
         {"walls.toml:11: event 1: time is missing; give when it is thrown, in s"}},
        {kBody + ball + without(kThrow, "object = 'ball'\n"),
         {"event 1: object is missing; give the name of the object that is thrown"}},
        {kBody + ball + without(kThrow, "from = [0, 1, 5]\n"),
         {"event 1: from is missing; give [x, y, z] in m, where its centre is then"}},
        {kBody + ball + without(kThrow, "velocity = [0, 0, -20]\n"),
         {"event 1: velocity is missing; give [x, y, z] in m/s"}},
        {kBody + kThrow,
         {"walls.toml:9: event 1: there is no object 'ball'; the scene has none: add a table "
          "[[object]]"}},
        {kBody + "[[object]]\nname = 'bal'\nshape = 'sphere'\nradius = 0.2\n" + kMass + kThrow,
         {"walls.toml:14: event 1: there is no object 'ball'; objects: bal",
          "did you mean 'bal'?"}},
        {kBody + fixed + kThrow,
         {"walls.toml:15: event 1: 'ball' is fixed; only others can be thrown"}},
        {kBody + hung + kThrow,
         {"walls.toml:16: event 1: 'ball' hangs from a chain; give it a velocity instead of "
          "throwing it"}},
        {kBody + ball + kThrow + "spin = [0, 0, 1e5]\n",
         {"walls.toml:17: event 1: spin: number 3 must be from -10000 to 10000 rad/s"}},
        {kBody + ball + kThrow + "radius = 1\n",
         {"walls.toml:17: event 1: an event of kind 'throw' has no 'radius'; leave it out, or "
          "change kind"}},
        {kBody + "[[event]]\nkind = 'impulse'\nobject = 'ball'\n",
         {"walls.toml:8: event 1: an event of kind 'impulse' has no 'object'"}},
        {kBody + "[[event]]\nkind = 'throws'\n",
         {"walls.toml:7: event 1: kind must be one of impulse, force, velocity, blast, throw, not "
          "the "
          "text 'throws'",
          "did you mean 'throw'?"}},
    };
    for (const Bad& bad : cases) {
        INFO("input: " << bad.text.substr(0, 400));
        checkParts(sceneError(bad.text), bad.parts);
    }
    for (const char* key : {"body = 'wall'", "point = [0, 1, 0]", "radius = 1",
                            "vector = [0, 0, 1]", "duration = 1"}) {
        const std::string name = std::string(key).substr(0, std::string(key).find(' '));
        const std::string message = sceneError(kBody + ball + kThrow + key + "\n");
        INFO("message: " << message);
        CHECK(message.find("'throw' has no '" + name + "'") != std::string::npos);
    }
    for (const char* key :
         {"object = 'ball'", "from = [0, 0, 0]", "velocity = [0, 0, 1]", "spin = [0, 0, 1]"}) {
        const std::string name = std::string(key).substr(0, std::string(key).find(' '));
        const std::string message =
            sceneError(kBody + "[[event]]\nkind = 'velocity'\n" + key + "\n");
        INFO("message: " << message);
        CHECK(message.find("'velocity' has no '" + name + "'") != std::string::npos);
    }
}
