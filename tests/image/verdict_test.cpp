// Each way in which a picture of the suite can fail has a verdict of its own.
#include "catch.hpp"
#include "files/write_file.hpp"
#include "gl/objects.hpp"
#include "gpu/test_context.hpp"
#include "image/renewal.hpp"
#include "image/results.hpp"
#include "support/test_folder.hpp"

using namespace sunder;
using namespace sunder::core;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const image::ComparisonLimits kLimits;

SuitePicture smallPicture() {
    SuitePicture picture;
    picture.name = picture.baseline = "small";
    picture.scene = "wood-thesis";
    picture.frame = 2;
    picture.settings.width = 64;
    picture.settings.height = 48;
    return picture;
}

/// A folder with the picture's state and baseline.
struct Renewed : TestFolder {
    Renewed() {
        suite.pictures = {picture};
        renew(suite, path(), testContext().info(), {});
    }
    PictureResult result(const DrawPicture& draw = drawUnchanged) const {
        return drawAndCompare(picture, path(), kLimits, draw);
    }
    SuitePicture picture = smallPicture();
    Suite suite;  // made by any driver
};

void makeGlError() {
    glEnable(GL_RGBA8);
}

image::Image drawWithGlError(const SuitePicture& picture, const fs::path& folder) {
    image::Image image = drawSuitePicture(picture, folder);
    makeGlError();
    return image;
}

image::Image throwAfterGlError(const SuitePicture&, const fs::path&) {
    makeGlError();
    throw InputError("no such wall");
}

void damage(const fs::path& file) {
    fs::resize_file(file, fs::file_size(file) / 2);
}

}  // namespace

TEST_CASE("a picture like its baseline is alike") {
    const Renewed renewed;
    const PictureResult result = renewed.result();
    CHECK(result.verdict == "alike");
    CHECK(result.holds());
    CHECK(result.accept.empty());
    CHECK(result.comparison->largest == 0);
}

TEST_CASE("missing baseline, damaged baseline, size mismatch and mismatch are told apart") {
    const Renewed renewed;
    const fs::path baseline = baselineOf(renewed.path(), renewed.picture);
    const std::string accept = "tools/update-baselines small";
    image::Image picture = image::readPng(baseline);

    SECTION("altered") {
        for (std::size_t i = 0; i < picture.pixels.size() / 4; ++i) picture.pixels[i] ^= 0x40;
        image::writePng(baseline, picture);
        const PictureResult result = renewed.result();
        CHECK(result.verdict == "mismatch");
        CHECK_THAT(result.sentence, Contains("share 0.25"));
        CHECK(result.accept == accept);
        CHECK(result.comparison->share == Approx(0.25));
    }
    SECTION("of another size") {
        picture.pixels.resize(picture.pixels.size() - std::size_t{3} * picture.width);
        --picture.height;
        image::writePng(baseline, picture);
        const PictureResult result = renewed.result();
        CHECK(result.verdict == "size mismatch");
        CHECK_THAT(result.sentence, Contains("64 x 48") && Contains("64 x 47"));
        CHECK(result.accept == accept);
        CHECK_FALSE(result.comparison);
    }
    SECTION("damaged") {
        damage(baseline);
        const PictureResult result = renewed.result();
        CHECK(result.verdict == "damaged baseline");
        CHECK_THAT(result.sentence, Contains("small.png"));
        CHECK(result.accept == accept);
        CHECK(result.actual);
    }
    SECTION("missing") {
        fs::remove(baseline);
        const PictureResult result = renewed.result();
        CHECK(result.verdict == "missing baseline");
        CHECK_THAT(result.sentence, Contains("small.png"));
        CHECK(result.accept == accept);
        CHECK(result.actual);
    }
}

TEST_CASE("a missing and a damaged state are told apart") {
    const Renewed renewed;
    const fs::path state = stateOf(renewed.path(), renewed.picture);
    SECTION("damaged") {
        damage(state);
        const PictureResult result = renewed.result();
        CHECK(result.verdict == "damaged state");
        CHECK_THAT(result.sentence, Contains("wood-thesis-2.state"));
        CHECK(result.accept == "tools/update-baselines --states small");
        CHECK_FALSE(result.actual);
    }
    SECTION("missing") {
        fs::remove(state);
        const PictureResult result = renewed.result();
        CHECK(result.verdict == "missing state");
        CHECK_THAT(result.sentence, Contains("wood-thesis-2.state"));
        CHECK(result.accept == "tools/update-baselines small");
        CHECK_FALSE(result.actual);
    }
}

TEST_CASE("a scene that cannot be drawn is a missing picture, and its errors stay its own") {
    const Renewed renewed;
    const PictureResult result = renewed.result(throwAfterGlError);
    CHECK(result.verdict == "missing picture");
    CHECK(result.sentence == "no such wall");
    CHECK(result.accept.empty());
    CHECK_FALSE(result.actual);
    CHECK(result.expected);
    CHECK(result.glErrors.size() == 1);
    CHECK(renewed.result().holds());

    SuitePicture unknown = renewed.picture;
    unknown.scene = "no-such-scene";
    unknown.frame = 0;
    CHECK(drawAndCompare(unknown, renewed.path(), kLimits).verdict == "missing picture");
}

TEST_CASE("a picture drawn with OpenGL errors fails, and no command accepts it") {
    const Renewed renewed;
    SECTION("though it is like its baseline") {
        const PictureResult result = renewed.result(drawWithGlError);
        CHECK(result.verdict == "GL errors");
        CHECK(result.glErrors.size() == 1);
        CHECK(result.accept.empty());
        CHECK(result.comparison->largest == 0);
    }
    SECTION("and has no baseline either") {
        fs::remove(baselineOf(renewed.path(), renewed.picture));
        const PictureResult result = renewed.result(drawWithGlError);
        CHECK(result.verdict == "GL errors");
        CHECK_THAT(result.sentence, Contains("missing baseline"));
        CHECK(result.accept.empty());
    }
    SECTION("unless they were there before") {
        testContext();
        makeGlError();
        CHECK(renewed.result().holds());
    }
}

TEST_CASE("a picture with another's baseline is not accepted by itself") {
    const Renewed renewed;
    SuitePicture gather = renewed.picture;
    gather.name = "gathered";
    gather.solver = SuiteSolver::Gather;
    CHECK(drawAndCompare(gather, renewed.path(), kLimits).holds());
    gather.settings.style = render::DrawStyle::Wireframe;
    const PictureResult result = drawAndCompare(gather, renewed.path(), kLimits);
    CHECK(result.verdict == "mismatch");
    CHECK(result.accept.empty());
}
