// Every picture of tests/image/suite.toml against its baseline, and proof that the comparison sees
// what it should: a baseline is worth nothing if a broken picture passes.
#include <cstdlib>
#include <filesystem>
#include <set>

#include "catch.hpp"
#include "gpu/test_context.hpp"
#include "image/suite.hpp"

using namespace sunder;
namespace fs = std::filesystem;

namespace {

const fs::path kFolder = SUNDER_IMAGE_TESTS;
const fs::path kReport = SUNDER_IMAGE_REPORT;

const Suite& suite() {
    static const Suite read = readSuite(kFolder / "suite.toml");
    return read;
}

bool onBaselineDriver() {
    return testContext().info().renderer.starts_with(suite().baselineRenderer);
}

const ComparisonLimits& limits() {
    return onBaselineDriver() ? suite().baselineLimits : suite().otherLimits;
}

const SuitePicture& pictureNamed(const std::string& name) {
    for (const SuitePicture& picture : suite().pictures)
        if (picture.name == name) return picture;
    throw InputError("the suite has no picture '" + name + "'");
}

fs::path baselineOf(const std::string& name) {
    return kFolder / "baselines" / (name + ".png");
}

std::string describe(const Comparison& c) {
    return "share " + std::to_string(c.share) + ", window " + std::to_string(c.windowShare) +
           " at " + std::to_string(c.windowX) + ", " + std::to_string(c.windowY) + ", mean " +
           std::to_string(c.mean);
}

/// What a person needs to see why: expected, actual and their difference, side by side in a folder.
void leaveBehind(const std::string& name, const Image& expected, const Image& actual,
                 const Comparison& comparison) {
    fs::create_directories(kReport);
    writePng(kReport / (name + "-expected.png"), expected);
    writePng(kReport / (name + "-actual.png"), actual);
    writePng(kReport / (name + "-difference.png"), differencePicture(expected, actual, comparison));
}

bool different(const Image& a, const Image& b) {
    return !compare(a, b, limits().threshold).alike(limits());
}

}  // namespace

TEST_CASE("pictures are what they were", "[image]") {
    for (const SuitePicture& picture : suite().pictures) {
        INFO(picture.name);
        if (!fs::exists(baselineOf(picture.name))) {
            FAIL_CHECK(
                "there is no baseline; look at the picture and accept it: "
                "tools/update-baselines "
                << picture.name);
            continue;
        }
        const Image expected = readPng(baselineOf(picture.name));
        const Image actual = drawSuitePicture(picture);
        CHECK(testContext().takeErrors().empty());
        REQUIRE(actual.width == expected.width);
        REQUIRE(actual.height == expected.height);
        const Comparison comparison = compare(expected, actual, limits().threshold);
        if (comparison.alike(limits())) continue;
        leaveBehind(picture.name, expected, actual, comparison);
        FAIL_CHECK("not the baseline: " << describe(comparison) << "; see " << kReport.string()
                                        << ", and accept it if it is right: tools/update-baselines "
                                        << picture.name);
    }
}

TEST_CASE("every baseline belongs to a picture", "[image]") {
    std::set<std::string> names;
    for (const SuitePicture& picture : suite().pictures) {
        CHECK(names.insert(picture.name).second);
    }
    for (const auto& entry : fs::directory_iterator(kFolder / "baselines"))
        CHECK(names.count(entry.path().stem().string()) == 1);
}

TEST_CASE("the comparison sees a camera moved by a pixel", "[image]") {
    for (const char* name : {"wood-broken", "brick-broken", "stress"}) {
        const SuitePicture& picture = pictureNamed(name);
        const auto moveCamera = [&](Scene& scene) {
            CameraDescription& camera = scene.camera;
            const Vec3 forward = camera.target - camera.position;
            const Vec3 right = forward.cross(Vec3(0, 1, 0)).normalized();
            const double tangent = std::tan(camera.fieldOfView * 3.141592653589793 / 360);
            // A pixel's width at the target.
            const double pixel = 2 * forward.norm() * tangent / picture.settings.height;
            camera.position += pixel * right;
            camera.target += pixel * right;
        };
        INFO(name);
        CHECK(different(drawSuitePicture(picture), drawSuitePicture(picture, moveCamera)));
    }
}

TEST_CASE("the comparison sees a missing chunk, another material, another seed", "[image]") {
    const SuitePicture& intact = pictureNamed("wood-intact");
    const Image before = drawSuitePicture(intact);
    CHECK_FALSE(different(before, drawSuitePicture(intact)));
    CHECK(different(before, drawSuitePicture(intact, [](Scene& scene) {
                        scene.world.bodies[0].regions = {{{20, 15, 0}, {20, 15, 0}, -1}};
                    })));
    CHECK(different(before, drawSuitePicture(intact, [](Scene& scene) {
                        scene.world.materials[0].colour *= 1.25;
                    })));
    const SuitePicture& broken = pictureNamed("concrete-broken");
    CHECK(different(drawSuitePicture(broken),
                    drawSuitePicture(broken, [](Scene& scene) { scene.world.seed = 2; })));
}

TEST_CASE("the comparison sees a blank picture and a picture without shadows or texture",
          "[image]") {
    const Image picture = drawSuitePicture(pictureNamed("brick-broken"));
    Image blank = picture;
    std::fill(blank.pixels.begin(), blank.pixels.end(), std::uint8_t{0});
    CHECK(different(picture, blank));
    CHECK(different(picture, drawSuitePicture(pictureNamed("brick-broken"), [](Scene& scene) {
                        scene.world.materials[0].surface = SurfaceKind::Plain;
                    })));
    CHECK(different(picture, drawSuitePicture(pictureNamed("brick-broken"),
                                              [](Scene& scene) { scene.world.ground = false; })));
}

// tools/update-baselines runs this, and nothing else does.
TEST_CASE("renew baselines", "[.update]") {
    if (std::getenv("CI")) FAIL("baselines are never renewed by a CI machine");
    if (!onBaselineDriver())
        FAIL("baselines are made with " << suite().baselineRenderer << "...), not with "
                                        << testContext().info().renderer);
    const char* only = std::getenv("SUNDER_BASELINE");
    bool any = false;
    for (const SuitePicture& picture : suite().pictures) {
        if (only && picture.name != only) continue;
        any = true;
        writePng(baselineOf(picture.name), drawSuitePicture(picture));
        WARN("wrote " << baselineOf(picture.name).string());
    }
    if (!any) FAIL("the suite has no picture '" << only << "'");
}
