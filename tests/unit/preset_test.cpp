// The scenes and materials that come with the program.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "catch.hpp"
#include "core/world.hpp"
#include "scene/scene.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("All presets can be read and laid out", "[scene]") {
    std::vector<std::string> names;
    for (const scene::PresetInfo& preset : scene::scenePresets()) {
        INFO(preset.name);
        names.push_back(preset.name);
        const scene::Scene scene = scene::loadScene(preset.name);
        CHECK(scene.name == preset.name);
        CHECK(preset.title == scene.title);
        CHECK(preset.title != preset.name);
        const World world(scene.world);
        CHECK(world.presentCells() == world.cellCount());
        CHECK(world.events().size() == scene.world.events.size());
        // Up to eight spheres cover a cell for contact: no side much longer than two others.
        if (scene.world.contact)
            for (const Body& body : world.bodies())
                CHECK(body.cellSize.maxCoeff() < 2.01 * body.cellSize.minCoeff());
    }
    CHECK(names == std::vector<std::string>{"brick", "cannon", "cantilever", "concrete", "glass",
                                            "heap", "peer-50x400", "peer-50x400-break", "planks",
                                            "rubber", "rubber-thesis", "stress", "wood",
                                            "wood-thesis", "wrecking-ball"});
    names.clear();
    for (const scene::PresetInfo& preset : scene::materialPresets()) {
        INFO(preset.name);
        names.push_back(preset.name);
        CHECK(scene::loadMaterial(preset.name).name == preset.name);
        CHECK_FALSE(preset.title.empty());
    }
    CHECK(names == std::vector<std::string>{"brick", "concrete", "glass", "planks", "rubber",
                                            "rubber-thesis", "wood", "wood-thesis"});
}

TEST_CASE("A preset scene's camera sees all of its bodies and objects", "[scene]") {
    for (const scene::PresetInfo& preset : scene::scenePresets()) {
        INFO(preset.name);
        const scene::Scene scene = scene::loadScene(preset.name);
        const Vec3 forward = (scene.camera.target - scene.camera.position).normalized();
        const Vec3 right = forward.cross(Vec3(0, 1, 0)).normalized();
        const Vec3 up = right.cross(forward);
        const double tangent = std::tan(scene.camera.fieldOfView * 3.141592653589793 / 360);
        double reach = 0;
        const auto look = [&](const Vec3& p) {
            const Vec3 d = p - scene.camera.position;
            const double depth = d.dot(forward);
            REQUIRE(depth > 0.1);
            reach = std::max({reach, std::abs(d.dot(right)) / depth / tangent / (16.0 / 9),
                              std::abs(d.dot(up)) / depth / tangent});
        };
        for (const BodyDescription& body : scene.world.bodies)
            for (int corner = 0; corner < kCorners; ++corner) {
                const Vec3 half = body.size / 2;
                look(body.position + Vec3(corner & 1 ? half[0] : -half[0],
                                          corner & 2 ? body.size[1] : 0,
                                          corner & 4 ? half[2] : -half[2]));
            }
        for (const ObjectDescription& object : scene.world.objects) {
            for (int corner = 0; object.position && corner < kCorners; ++corner) {
                const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
                const bool box = object.shape == ObjectShape::Box;
                look(*object.position + (box ? Vec3(sign.cwiseProduct(object.halfSize))
                                             : Vec3(sign[0] * object.halfSize[0] * up)));
            }
            if (object.hungFrom) look(*object.hungFrom);
        }
        CHECK(reach < 1);    // nothing is cut off at 16:9
        CHECK(reach > 0.6);  // and it fills most of the picture
        CHECK(scene.camera.position.y() > 0);
        CHECK(scene.camera.position.z() > 0);
    }
}

TEST_CASE("Every ball of the cannon is thrown once, at 20 to 40 m/s", "[scene]") {
    const scene::Scene scene = scene::loadScene("cannon");
    CHECK(scene.world.bodies.size() == 50);
    REQUIRE(scene.world.objects.size() == 20);
    REQUIRE(scene.world.throws.size() == 20);
    for (int i = 0; i < 20; ++i) {
        const ThrowDescription& thrown = scene.world.throws[i];
        CHECK(thrown.object == i);
        CHECK_FALSE(scene.world.objects[i].position);
        CHECK(thrown.velocity.norm() >= 20);
        CHECK(thrown.velocity.norm() <= 41);
        CHECK(60 * thrown.time < scene.frames);
    }
}

TEST_CASE("The wrecking ball is of iron and just touches the wall where it hangs", "[scene]") {
    const WorldDescription world = scene::loadScene("wrecking-ball").world;
    REQUIRE(world.objects.size() == 1);
    const ObjectDescription& ball = world.objects[0];
    const double radius = ball.halfSize[0];
    CHECK(ball.mass ==
          Approx(7870 * 4.0 / 3 * 3.141592653589793 * std::pow(radius, 3)).epsilon(.1));
    const double front = world.bodies[0].size[2] / 2;
    CHECK(ball.hungFrom->z() - radius == Approx(front).margin(0.05));
    const double lowest = ball.hungFrom->y() - (*ball.position - *ball.hungFrom).norm();
    CHECK(lowest - radius > 0);
    CHECK(lowest + radius < world.bodies[0].size[1]);
}

TEST_CASE("The peer scenes take the fewest substeps that carry their stiffness", "[scene]") {
    for (const auto& [name, fracture] : {std::pair{"peer-50x400", FractureMode::None},
                                         {"peer-50x400-break", FractureMode::Bond}}) {
        INFO(name);
        scene::Scene scene = scene::loadScene(name);
        const World world(scene.world);
        CHECK(world.bodies().size() == 50);
        CHECK(kTetrahedraPerCell * world.presentCells() == 20'000);
        CHECK(world.events().size() == 50);
        REQUIRE(world.laws().size() == 1);
        CHECK_FALSE(world.laws()[0].limited);
        const Material& material = world.materialOf(0);
        CHECK(material.youngModulus == 4e6);
        CHECK(material.poissonRatio == 0.3);
        CHECK(material.density == 1000);
        CHECK(material.law == ConstitutiveLaw::Corotated);
        CHECK(material.fracture == fracture);

        scene.world.step = 1.0 / (60.0 * (scene.substeps - 1));
        CHECK(World(scene.world).laws()[0].limited);
    }
}

TEST_CASE("The thesis's presets hold its chapter 9 table", "[scene]") {
    const Material rubber = scene::loadMaterial("rubber-thesis");
    const Material wood = scene::loadMaterial("wood-thesis");
    const auto check = [](const Material& m, std::vector<double> expected) {
        const std::vector<double> actual{m.youngModulus,
                                         m.poissonRatio,
                                         m.damping,
                                         m.gravity,
                                         m.maxStress,
                                         m.avgDisplaySectionWidth,
                                         m.avgDisplaySectionHeight,
                                         m.randDisplaySectionWidth,
                                         m.randDisplaySectionHeight,
                                         m.horizEdgeFrequency,
                                         m.horizEdgeAmplitude,
                                         m.vertEdgeFrequency,
                                         m.vertEdgeAmplitude};
        CHECK(actual == expected);
        CHECK(m.law == ConstitutiveLaw::Green);
        CHECK(m.fracture == FractureMode::Cell);
    };
    check(rubber, {500, 0.3, 0.7, 1, 1000, 0.3, 0.8, 0, 0, 0, 0, 0, 0});
    check(wood, {700, 0.3, 0.7, 1, 1, 0.3, 0.8, 0.2, 0.2, 1, 0.1, 1, 0.1});

    for (const char* name : {"rubber-thesis", "wood-thesis"}) {
        const World world(scene::loadScene(name).world);
        CHECK(world.cellCount() * kTetrahedraPerCell == 270);
        CHECK((world.bodies()[0].cells + IVec3(1, 1, 1)).prod() == 152);
    }
    const World stress(scene::loadScene("stress").world);
    CHECK(stress.bodies().size() == 50);
    CHECK(stress.cellCount() * kTetrahedraPerCell == 13500);
    CHECK(stress.events().size() == 50);
}

TEST_CASE("The bond-breaking presets hold the measured table", "[scene]") {
    const double MPa = 1e6;
    struct Row {
        std::string name;
        double E, nu, density;
        Vec3 strength, boundary;  // MPa
        ClusterKind clusters;
        double spread, damageLength, shearWeight, friction, drag;
    };
    const auto all = [](double s) { return Vec3(s, s, s); };
    const std::vector<Row> rows{
        // Tougher than measured by the prototype (13 and 4.55 MPa, 0.8 m): with our contact these
        // give
        // its 1, 20 and 90 pieces at 5, 15 and 40 m/s.
        {"concrete", 30e9, .2, 2400, all(16), all(5.6), ClusterKind::Voronoi, .2, 1, .3, .6, 1},
        {"brick",
         10e9,
         .2,
         1900,
         {18, 31, 18},
         {3.6, 6.1, 3.6},
         ClusterKind::RunningBond,
         .25,
         .9,
         .5,
         .6,
         1},
        {"wood",
         10e9,
         .3,
         600,
         {4.5, 22.5, 4.5},
         {4.5, 22.5, 4.5},
         ClusterKind::None,
         .35,
         1,
         .3,
         .2,
         1.5},
        {"planks",
         10e9,
         .3,
         600,
         {14, 28, 14},
         all(1.4),
         ClusterKind::Planks,
         .25,
         .8,
         .3,
         .3,
         1.5},
        {"glass", 70e9, .2, 2500, all(18), all(3.6), ClusterKind::Voronoi, .3, 1.6, .3, .3, .5},
        {"rubber", 10e6, .3, 1100, all(1.4), all(1.4), ClusterKind::None, .15, .4, .3, .3, 2},
    };
    for (const Row& row : rows) {
        INFO(row.name);
        const Material m = scene::loadMaterial(row.name);
        CHECK(m.law == ConstitutiveLaw::Corotated);
        CHECK(m.fracture == FractureMode::Bond);
        CHECK(m.youngModulus == row.E);
        CHECK(m.poissonRatio == row.nu);
        CHECK(m.density == row.density);
        CHECK(m.strength.isApprox(row.strength * MPa, 1e-12));
        CHECK(m.boundaryStrength.isApprox(row.boundary * MPa, 1e-12));
        CHECK(m.clusters == row.clusters);
        CHECK(m.spread == row.spread);
        CHECK(m.damageLength == row.damageLength);
        CHECK(m.shearWeight == row.shearWeight);
        CHECK(m.internalFriction == row.friction);
        CHECK(m.damping == row.drag);
        CHECK((m.noiseAmplitude > 0) == (row.name == "wood"));
    }
    const Material wood = scene::loadMaterial("wood");
    CHECK(wood.noiseLength == 0.35);
    CHECK(wood.noiseAmplitude == 0.48);
    CHECK(scene::loadMaterial("concrete").clusterSize == Vec3(0.4, 0.4, 0));
    CHECK(scene::loadMaterial("planks").clusterSize.x() == 0.2);
    CHECK(scene::loadMaterial("brick").clusterSize.head<2>() == Eigen::Vector2d(0.4, 0.2));
    CHECK(scene::loadMaterial("glass").clusterSize.y() ==
          Approx(3 * scene::loadMaterial("glass").clusterSize.x()));
}
