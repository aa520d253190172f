// How many substeps a world's materials need, and the intervals of time that follow from steps.
#include "core/substeps.hpp"
#include "catch.hpp"
#include "core/world.hpp"
#include "scene/scene.hpp"
#include "scene/scene_writer.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

using Catch::Contains;

namespace {

bool limits(WorldDescription d, int substeps) {
    d.step = 1.0 / (60 * substeps);
    const World world(std::move(d));
    return std::any_of(world.laws().begin(), world.laws().end(),
                       [](const ElementLaw& law) { return law.limited; });
}

WorldDescription stiff(double youngModulus) {
    WorldDescription d = block({7, 5, 3}, brittle());
    d.materials[0].youngModulus = youngModulus;
    return d;
}

const std::string kWall = R"(
[material.mine]
base = "concrete"
[[body]]
name = "wall"
material = "mine"
size = [1, 1, 0.2]
cells = [10, 10, 2]
)";

}  // namespace

TEST_CASE("Automatic substeps are the fewest that limit no material", "[scene]") {
    for (const double E : {1e5, 3.7e8, 30e9, 2e11}) {
        INFO(E);
        const WorldDescription d = stiff(E);
        const int substeps = substepsFor(d, 100000);
        CHECK_FALSE(limits(d, substeps));
        if (substeps > kFewestSubsteps) {
            CHECK(substeps % kLookSteps == 0);
            CHECK(limits(d, substeps - kLookSteps));
        }
    }
    CHECK(substepsFor(stiff(1e5), 100000) == kFewestSubsteps);
    CHECK(substepsFor(stiff(30e9), 700) == 700);
    CHECK(substepsFor(stiff(1e5), 20) == 20);
}

TEST_CASE("Automatic substeps follow the stiffest cells of any body", "[scene]") {
    WorldDescription d = stiff(1e7);
    const int soft = substepsFor(d, 100000);
    Material stiffer = d.materials[0];
    stiffer.youngModulus = 9e9;
    d.materials.push_back(stiffer);
    CHECK(substepsFor(d, 100000) == soft);  // no cell has it
    d.bodies[0].regions = {{{1, 1, 1}, {2, 2, 2}, 1}};
    const int region = substepsFor(d, 100000);
    // √(9e9/1e7) = 30 times as many, but for rounding up; the soft wall alone may need fewer than
    // there are at least.
    CHECK(region == substepsFor(stiff(9e9), 100000));
    BodyDescription fine = d.bodies[0];
    fine.name = "fine";
    fine.position = {5, 0, 0};
    fine.cells *= 2;
    fine.present = false;  // it may come
    d.bodies.push_back(fine);
    CHECK(std::abs(substepsFor(d, 100000) - 2 * region) <= kLookSteps);
}

TEST_CASE("A scene's substeps may be automatic, bounded, and written back so", "[scene]") {
    const auto parsed = [](const std::string& solver) {
        return scene::parseScene(solver + kWall, "walls.toml", {});
    };
    CHECK(parsed("").substeps == 50);
    scene::Scene scene = parsed("[solver]\nsubsteps = \"auto\"\n");
    CHECK(scene.substeps == substepsFor(scene.world, 100000));
    CHECK(scene.substeps > 1000);
    CHECK(scene.world.step == 1.0 / (60 * scene.substeps));
    const scene::Scene bounded = parsed("[solver]\nsubsteps = \"auto\"\nmax_substeps = 300\n");
    CHECK(bounded.substeps == 300);
    const scene::Scene again = scene::parseScene(scene::writeScene(bounded), "again.toml", {});
    CHECK(again.autoSubsteps);
    CHECK(again.maxSubsteps == 300);
    CHECK(again.substeps == 300);
    // A softer material: fewer.
    scene.world.materials[0].youngModulus /= 16;
    const int before = scene.substeps;
    scene::chooseSubsteps(scene);
    CHECK(std::abs(scene.substeps - before / 4) <= kLookSteps);
    const auto sentence = [&](const std::string& solver) {
        try {
            parsed(solver);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(
        sentence("[solver]\nsubsteps = \"most\"\n"),
        Contains("walls.toml:2: solver: substeps must be a number or 'auto', not the text 'most'"));
    CHECK_THAT(
        sentence("[solver]\nsubsteps = 60\nmax_substeps = 300\n"),
        Contains("walls.toml:3: solver: max_substeps says nothing where substeps is a number"));
    CHECK_THAT(
        sentence("[solver]\nsubsteps = \"auto\"\nmax_substeps = 10001\n"),
        Contains("walls.toml:3: solver: max_substeps must be a whole number from 1 to 10000"));
}

TEST_CASE("Fracture looks and contact searches come at the same times at any number of substeps",
          "[scene]") {
    const int enough = substepsFor(stiff(30e9), 100000);
    double look = 0;
    for (const int times : {1, 2, 4}) {
        WorldDescription d = stiff(30e9);
        d.contact = true;
        d.step = 1.0 / (60 * times * enough);
        const World world(d);
        CHECK(world.fractureInterval() == kLookSteps * times);
        if (look > 0) CHECK(world.fractureInterval() * world.step() == Approx(look));
        look = world.fractureInterval() * world.step();
        CHECK(world.contactInterval() % kContactSteps == 0);
        CHECK(world.contactTime() <= kContactTime * (1 + 1e-9));
        CHECK(world.contactTime() > kContactTime - kContactSteps * world.step());
    }
    // Limited, a material is looked at every four substeps, and so it is searched at fifty.
    for (const int substeps : {10, 50}) {
        WorldDescription d = stiff(30e9);
        d.step = 1.0 / (60 * substeps);
        CHECK(World(d).fractureInterval() == kLookSteps);
        CHECK(World(d).contactInterval() == kContactSteps);
    }
    // What does not break is not looked at, and a number is that number.
    WorldDescription d = stiff(30e9);
    d.step = 1.0 / (60 * 4 * enough);
    d.fractureInterval = 7;
    CHECK(World(d).fractureInterval() == 7);
}
