// What material files set, and what mistakes in them are answered with.
#include <string>
#include <vector>

#include "catch.hpp"
#include "core/rules.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

using namespace sunder;
using namespace sunder::core;

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

TEST_CASE("A value of a material ends in the right field", "[scene]") {
    for (const Rule<Material>& rule : materialRules()) {
        INFO(rule.key);
        const double inside = rule.range.min + 0.25 * (rule.range.max - rule.range.min);
        const Material m = scene::parseMaterial(
            std::string(rule.key) + " = " + std::to_string(inside) + "\n", "stuff.toml");
        const Numbers numbers = rule.get(m);
        REQUIRE(numbers.count == rule.count());
        for (int i = 0; i < numbers.count; ++i) CHECK(numbers.values[i] == Approx(inside));
    }
}

TEST_CASE("Boundary strength follows strength until it has a value of its own", "[scene]") {
    const Material plain = scene::parseMaterial("strength = [1, 2, 3]", "m.toml");
    CHECK(plain.strength == Vec3(1, 2, 3));
    CHECK(plain.boundaryStrength == Vec3(1, 2, 3));
    const Material both =
        scene::parseMaterial("strength = 5\nboundary_strength = [1, 2, 3]", "m.toml");
    CHECK(both.strength == Vec3(5, 5, 5));
    CHECK(both.boundaryStrength == Vec3(1, 2, 3));
    // Concrete's chunks keep their weak boundaries.
    const Material base = scene::parseMaterial("base = 'concrete'\nstrength = 20e6", "m.toml");
    CHECK(base.strength == Vec3(20e6, 20e6, 20e6));
    CHECK(base.boundaryStrength == Vec3(5.6e6, 5.6e6, 5.6e6));
}

TEST_CASE("Materials build on one another", "[scene]") {
    // Written in an order in which each base comes after its user; `wood` builds on the preset it
    // hides.
    const scene::Scene scene = scene::parseScene(
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
