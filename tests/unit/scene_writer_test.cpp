// What the viewer saves is what it was.
#include "scene/scene_writer.hpp"

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/rules.hpp"
#include "cpu/cpu_solver.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

void checkSame(const Material& a, const Material& b) {
    CHECK(a.description == b.description);
    CHECK(a.law == b.law);
    CHECK(a.fracture == b.fracture);
    CHECK(a.clusters == b.clusters);
    CHECK(a.surface == b.surface);
    for (const Rule<Material>& rule : materialRules()) {
        INFO(rule.key);
        CHECK(rule.get(a).values == rule.get(b).values);
    }
}

std::uint64_t hashAfter(const scene::Scene& scene, int frames) {
    const World world(scene.world);
    cpu::CpuSolver solver(world, 1);
    solver.advance(frames * scene.substeps);
    return stateHash(solver.state());
}

}  // namespace

TEST_CASE("Every preset material is read back as it was written", "[scene]") {
    for (const scene::PresetInfo& preset : scene::materialPresets()) {
        INFO(preset.name);
        const Material material = scene::loadMaterial(preset.name);
        const Material again =
            scene::parseMaterial(scene::writeMaterial(material), preset.name + ".toml");
        CHECK(again.name == material.name);
        checkSame(again, material);
    }
}

TEST_CASE("Numbers that no decimal is short for, and quotes, survive being written", "[scene]") {
    Material material = scene::loadMaterial("wood");
    material.youngModulus = 1.0 / 3 * 1e7;
    material.poissonRatio = 0.49999999999999994;
    material.damping = 1e-300;
    material.strength = Vec3(1e15, 1.0 / 7, 3e-200);
    material.description = "He said \"hit it\" \\ twice; µ = 0.3";
    checkSame(scene::parseMaterial(scene::writeMaterial(material), "odd.toml"), material);
}

TEST_CASE("Every preset scene, written and read, is the same world", "[scene]") {
    for (const scene::PresetInfo& preset : scene::scenePresets()) {
        INFO(preset.name);
        const scene::Scene scene = scene::loadScene(preset.name);
        const std::string text = scene::writeScene(scene);
        const scene::Scene again = scene::parseScene(text, preset.name + ".toml", {});
        CHECK(again.title == scene.title);
        CHECK(again.frames == scene.frames);
        CHECK(again.substeps == scene.substeps);
        CHECK(again.world.seed == scene.world.seed);
        CHECK(again.camera.position == scene.camera.position);
        CHECK(again.camera.target == scene.camera.target);
        CHECK(again.camera.fieldOfView == scene.camera.fieldOfView);
        REQUIRE(again.world.bodies.size() == scene.world.bodies.size());
        for (std::size_t i = 0; i < scene.world.bodies.size(); ++i)
            checkSame(again.world.materials[again.world.bodies[i].material],
                      scene.world.materials[scene.world.bodies[i].material]);
        CHECK(again.world.events.size() == scene.world.events.size());
        CHECK(again.world.throws.size() == scene.world.throws.size());
        CHECK(again.world.objects.size() == scene.world.objects.size());
        // Written again it is the same text: nothing drifts from save to save.
        CHECK(scene::writeScene(again) == text);
    }
}

TEST_CASE("Bodies that are turned are saved as they were written", "[scene]") {
    const char* body =
        "[[body]]\nname = \"w\"\nmaterial = \"wood\"\nsize = [1, 1, 1]\ncells = [1, 1, 1]\n";
    for (const char* angles : {"[0, 30, 0]", "[10, 20, -30.5]", "[0, 90, 0]", "[0, -90, 25]",
                               "[-90, 0, 0]", "[0, 0, 180]", "[170, 45, 1e-05]"}) {
        INFO(angles);
        const std::string line = std::string("rotation = ") + angles + "\n";
        const scene::Scene scene =
            scene::parseScene(body + line + "position = [0, 9, 0]\n", "turned.toml", {});
        const std::string text = scene::writeScene(scene);
        CHECK(text.find(line) != std::string::npos);
        const scene::Scene again = scene::parseScene(text, "turned.toml", {});
        CHECK(again.world.bodies[0].orientation.coeffs() ==
              scene.world.bodies[0].orientation.coeffs());
    }
    // Of many triples of angles that are the same turn, another one may be written.
    const scene::Scene scene =
        scene::parseScene(std::string(body) + "rotation = [200, 100, -300]\nposition = [0, 9, 0]\n",
                          "turned.toml", {});
    const scene::Scene again = scene::parseScene(scene::writeScene(scene), "turned.toml", {});
    CHECK(std::abs(again.world.bodies[0].orientation.dot(scene.world.bodies[0].orientation)) ==
          Approx(1).margin(1e-15));
    CHECK(scene::writeScene(again) == scene::writeScene(scene));
    CHECK(scene::writeScene(scene::parseScene(body, "plain.toml", {})).find("rotation") ==
          std::string::npos);
}

TEST_CASE("A scene that was saved runs to the same state, to the bit", "[scene]") {
    for (const char* name : {"wood", "glass", "brick", "wrecking-ball"}) {
        INFO(name);
        scene::Scene scene = scene::loadScene(name);
        for (EventDescription& event : scene.world.events) event.time = 0.01;
        EventDescription blast;
        blast.time = 0.02;
        blast.kind = EventDescription::Kind::Velocity;
        blast.body = kEveryBody;
        blast.point = {0.1, 0.7, 0.2};
        blast.radius = 0.8;
        blast.outward = 7;
        blast.vector = {1, 2, -3};
        blast.falloff = name[0] == 'w';
        scene.world.events.push_back(blast);
        const scene::Scene again = scene::parseScene(scene::writeScene(scene), "saved.toml", {});
        CHECK(hashAfter(again, 4) == hashAfter(scene, 4));
    }
}

TEST_CASE("A body that is not there from the start is saved as such", "[scene]") {
    const std::string body =
        "[[body]]\nname = \"wall\"\nmaterial = \"wood\"\nsize = [1, 1, 0.1]\ncells = [4, 4, 1]\n";
    CHECK(scene::parseScene(body, "there.toml", {}).world.bodies[0].present);
    const scene::Scene scene = scene::parseScene(body + "present = false\n", "absent.toml", {});
    CHECK_FALSE(scene.world.bodies[0].present);
    CHECK_FALSE(
        scene::parseScene(scene::writeScene(scene), "absent.toml", {}).world.bodies[0].present);
    CHECK(World(scene.world).initialState().absent == std::vector{0});
}
