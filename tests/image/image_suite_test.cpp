// Every picture of tests/image/suite.toml against its baseline, and proof that the comparison sees
// what it should: a baseline is worth nothing if a broken picture passes.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "catch.hpp"
#include "core/pieces.hpp"
#include "gl/shader_assembly.hpp"
#include "gpu/test_context.hpp"
#include "image/results.hpp"
#include "image/stored_state.hpp"

using namespace sunder;
using namespace sunder::core;
namespace fs = std::filesystem;

namespace {

const fs::path kFolder = SUNDER_IMAGE_TESTS;

const Suite& suite() {
    static const Suite read = readSuite(kFolder / "suite.toml");
    return read;
}

image::ComparisonLimits limitsOf(const SuitePicture& picture) {
    return suite().limits(picture, testContext().info());
}

/// A picture must differ from what it was before a change, by the suite's limits and by those
/// that `sunder compare` has where none are given. Is reported.
void checkSeen(const std::string& change, const std::string& name, const image::Image& before,
               const image::Image& after) {
    const image::ComparisonLimits limits = limitsOf(suite().picture(name)), byDefault;
    const image::Comparison comparison = image::compare(before, after, limits.threshold);
    const bool seen = !comparison.alike(limits);
    const bool seenByDefault = !image::compare(before, after, byDefault.threshold).alike(byDefault);
    writeControlResult(name, change, comparison, limits, seen, seenByDefault);
    CAPTURE(name, change, seen, seenByDefault);
    CHECK(seen);
    CHECK(seenByDefault);
}

image::Image drawn(
    const std::string& name, const SceneChange& change = [](scene::Scene&) {}) {
    return drawSuitePicture(suite().picture(name), kFolder, change);
}

void checkSeen(const std::string& change, const std::string& name, const SceneChange& make) {
    checkSeen(change, name, drawn(name), drawn(name, make));
}

/// Moves the camera to its right by a pixel's width at its target.
void moveByPixel(scene::Scene& scene, int pictureHeight) {
    scene::CameraDescription& camera = scene.camera;
    const Vec3 forward = camera.target - camera.position;
    const Vec3 right = forward.cross(Vec3(0, 1, 0)).normalized();
    const double tangent = std::tan(camera.fieldOfView * 3.141592653589793 / 360);
    const double pixel = 2 * forward.norm() * tangent / pictureHeight;
    camera.position += pixel * right;
    camera.target += pixel * right;
}

/// Cells of a piece of middling size among those of four and more in a picture's state: the
/// smallest may be out of sight.
std::vector<int> middlingChunk(const std::string& name) {
    const SuitePicture& picture = suite().picture(name);
    const World world(scene::loadScene(picture.scene).world);
    const Pieces pieces = findPieces(world, readState(stateOf(kFolder, picture), world));
    std::vector<std::vector<int>> cells(pieces.count);
    for (int cell = 0; cell < world.cellCount(); ++cell)
        if (pieces.ofCell[cell] >= 0) cells[pieces.ofCell[cell]].push_back(cell);
    std::erase_if(cells, [](const auto& piece) { return piece.size() < 4; });
    REQUIRE(cells.size() > 1);
    std::sort(cells.begin(), cells.end(),
              [](const auto& one, const auto& other) { return one.size() < other.size(); });
    return cells[cells.size() / 2];
}

void removeCell(scene::Scene& scene, const IVec3& at, int body = 0) {
    scene.world.bodies[body].regions.push_back({at, at, -1});
}

/// As if these cells had never been there.
void remove(scene::Scene& scene, const std::vector<int>& cells) {
    const World world(scene.world);
    for (const int cell : cells) {
        const int body = world.bodyOf(cell);
        removeCell(scene, world.bodies()[body].coordinates(cell), body);
    }
}

}  // namespace

// One picture alone: sunder_image_tests "pictures are what they were" -c NAME
TEST_CASE("pictures are what they were", "[image]") {
    static const bool cleared = (clearPictureResults(), true);
    REQUIRE(cleared);
    const bool onBaselineDriver = suite().madeBaselines(testContext().info());
    for (const SuitePicture& picture : suite().pictures) DYNAMIC_SECTION(picture.name) {
            const image::ComparisonLimits limits = limitsOf(picture);
            const PictureResult result = drawAndCompare(picture, kFolder, limits);
            writePictureResult(picture, result, limits, onBaselineDriver);
            CAPTURE(picture.name, result.glErrors);
            const std::string accept =
                result.accept.empty() ? "" : ", and if it is right: " + result.accept;
            if (!result.holds())
                FAIL_CHECK(result.verdict << ": " << result.sentence
                                          << "; look at it with tools/report" << accept);
        }
}

TEST_CASE("every baseline and every stored state belongs to a picture", "[image]") {
    std::set<fs::path> wanted, found;
    for (const SuitePicture& picture : suite().pictures) {
        wanted.insert(baselineOf(kFolder, picture));
        if (picture.storedState()) wanted.insert(stateOf(kFolder, picture));
    }
    for (const char* folder : {"baselines", "states"})
        for (const auto& entry : fs::directory_iterator(kFolder / folder))
            if (entry.path().filename() != ".gitattributes") found.insert(entry.path());
    CHECK(found == wanted);
}

TEST_CASE("the comparison sees a camera moved by a pixel", "[image]") {
    for (const char* name : {"wood-broken", "brick-broken", "glass-broken", "stress"}) {
        const int height = suite().picture(name).settings.height;
        checkSeen("camera moved by a pixel", name,
                  [&](scene::Scene& scene) { moveByPixel(scene, height); });
    }
}

TEST_CASE("the comparison sees a missing chunk, another material, another seed", "[image]") {
    CHECK(image::compare(drawn("wood-intact"), drawn("wood-intact"), 0).largest == 0);
    checkSeen("a cell missing", "wood-intact", [](scene::Scene& scene) {
        removeCell(scene, {20, 15, 0});
    });
    // At the wall's far end it is less than the bounds of other drivers let through.
    const image::Image far = drawn("wood-intact", [](scene::Scene& scene) {
        removeCell(scene, {0, 0, 0});
    });
    CHECK_FALSE(image::compare(drawn("wood-intact"), far, image::ComparisonLimits{}.threshold)
                    .alike(image::ComparisonLimits{}));
    for (const char* name : {"wood-broken", "concrete-broken"})
        checkSeen("a chunk missing", name,
                  [&](scene::Scene& scene) { remove(scene, middlingChunk(name)); });
    checkSeen("of concrete", "wood-intact", [](scene::Scene& scene) {
        scene.world.materials[0] = scene::loadMaterial("concrete");
    });
    checkSeen("a paler material", "wood-intact",
              [](scene::Scene& scene) { scene.world.materials[0].colour *= 1.25; });
    checkSeen("another seed", "concrete-broken", [](scene::Scene& scene) { scene.world.seed = 2; });
}

TEST_CASE("the comparison sees a blank picture and a picture without shadows or texture",
          "[image]") {
    const image::Image picture = drawn("brick-broken");
    image::Image blank = picture;
    std::fill(blank.pixels.begin(), blank.pixels.end(), std::uint8_t{0});
    checkSeen("all black", "brick-broken", picture, blank);
    // As when walls are not drawn: behind the camera, near enough to leave the haze as it was.
    checkSeen("sky and ground alone", "brick-broken",
              [](scene::Scene& scene) { scene.world.bodies[0].position[2] += 6; });
    checkSeen("no texture", "brick-broken",
              [](scene::Scene& scene) { scene.world.materials[0].surface = SurfaceKind::Plain; });
    checkSeen("no ground", "brick-broken", [](scene::Scene& scene) { scene.world.ground = false; });
}

TEST_CASE("the comparison sees edges made of the bricks beyond them", "[image]") {
    const std::string hair = "HAIR = 1e-3";  // how far inside the shader asks what a place is
    const gl::ShaderSource embedded = gl::embeddedShaders();
    const auto drawnAt = [&](const std::string& other) {
        gl::useShaders([&](std::string_view name) {
            std::optional<std::string> text = embedded(name);
            if (name != "draw/solid.glsl") return text;
            const std::size_t at = text->find(hair);
            REQUIRE(at != std::string::npos);
            return std::optional(text->replace(at, hair.size(), other));
        });
        const image::Image image = drawn("brick-edge");
        gl::useShaders(embedded);
        return image;
    };
    const image::Image right = drawn("brick-edge");
    checkSeen("a hair outside", "brick-edge", right, drawnAt("HAIR = -1e-3"));
    // Rounding decides for each pixel, which another driver may do alike for all.
    if (suite().madeBaselines(testContext().info()))
        checkSeen("neither inside nor outside", "brick-edge", right, drawnAt("HAIR = 0.0"));
}
