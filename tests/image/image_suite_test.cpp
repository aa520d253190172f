// Every picture of tests/image/suite.toml against its baseline, and proof that the comparison sees
// what it should: a baseline is worth nothing if a broken picture passes.
#include <cstdlib>
#include <filesystem>
#include <set>

#include "catch.hpp"
#include "gpu/test_context.hpp"
#include "image/results.hpp"

using namespace sunder;
namespace fs = std::filesystem;

namespace {

const fs::path kFolder = SUNDER_IMAGE_TESTS;

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

using Change = std::function<void(Scene&)>;

/// Whether a picture differs from what it was before a change, which is reported.
bool sees(const std::string& change, const std::string& name, const Image& before,
          const Image& after) {
    const Comparison comparison = compare(before, after, limits().threshold);
    writeControlResult(name, change, comparison, limits());
    return !comparison.alike(limits());
}

bool sees(const std::string& change, const std::string& name, const Change& make) {
    const SuitePicture& picture = pictureNamed(name);
    return sees(change, name, drawSuitePicture(picture), drawSuitePicture(picture, make));
}

/// Moves the camera to its right by a pixel's width at its target.
void moveByPixel(Scene& scene, int pictureHeight) {
    CameraDescription& camera = scene.camera;
    const Vec3 forward = camera.target - camera.position;
    const Vec3 right = forward.cross(Vec3(0, 1, 0)).normalized();
    const double tangent = std::tan(camera.fieldOfView * 3.141592653589793 / 360);
    const double pixel = 2 * forward.norm() * tangent / pictureHeight;
    camera.position += pixel * right;
    camera.target += pixel * right;
}

}  // namespace

// One picture alone: sunder_image_tests "pictures are what they were" -c NAME
TEST_CASE("pictures are what they were", "[image]") {
    static const bool cleared = (clearPictureResults(), true);
    REQUIRE(cleared);
    for (const SuitePicture& picture : suite().pictures) DYNAMIC_SECTION(picture.name) {
            const PictureResult result =
                drawAndCompare(picture, baselineOf(picture.name), limits());
            writePictureResult(picture, result, limits(), onBaselineDriver());
            CAPTURE(picture.name, result.glErrors);
            if (!result.holds())
                FAIL_CHECK(result.verdict << ": " << result.sentence
                                          << "; look at it with tools/report, and if it is right: "
                                             "tools/update-baselines "
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
        INFO(name);
        const int height = pictureNamed(name).settings.height;
        CHECK(sees("camera moved by a pixel", name,
                   [&](Scene& scene) { moveByPixel(scene, height); }));
    }
}

TEST_CASE("the comparison sees a missing chunk, another material, another seed", "[image]") {
    const Image intact = drawSuitePicture(pictureNamed("wood-intact"));
    CHECK(compare(intact, drawSuitePicture(pictureNamed("wood-intact")), limits().threshold)
              .alike(limits()));
    CHECK(sees("a cell missing", "wood-intact", [](Scene& scene) {
        scene.world.bodies[0].regions = {{{20, 15, 0}, {20, 15, 0}, -1}};
    }));
    CHECK(sees("a paler material", "wood-intact",
               [](Scene& scene) { scene.world.materials[0].colour *= 1.25; }));
    CHECK(sees("another seed", "concrete-broken", [](Scene& scene) { scene.world.seed = 2; }));
}

TEST_CASE("the comparison sees a blank picture and a picture without shadows or texture",
          "[image]") {
    const Image picture = drawSuitePicture(pictureNamed("brick-broken"));
    Image blank = picture;
    std::fill(blank.pixels.begin(), blank.pixels.end(), std::uint8_t{0});
    CHECK(sees("a blank picture", "brick-broken", picture, blank));
    CHECK(sees("no texture", "brick-broken",
               [](Scene& scene) { scene.world.materials[0].surface = SurfaceKind::Plain; }));
    CHECK(sees("no ground", "brick-broken", [](Scene& scene) { scene.world.ground = false; }));
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
