#include "image/results.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "files/write_file.hpp"
#include "gpu/test_context.hpp"

using namespace sunder;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const fs::path kReport = SUNDER_REPORT;

std::string size(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

std::string describe(const Comparison& c) {
    return "share " + std::to_string(c.share) + ", window " + std::to_string(c.windowShare) +
           " at " + std::to_string(c.windowX) + ", " + std::to_string(c.windowY) + ", mean " +
           std::to_string(c.mean);
}

json toJson(const Comparison& c) {
    return {{"share", c.share},
            {"window", c.windowShare},
            {"mean", c.mean},
            {"largest", c.largest},
            {"worst_window", {c.windowX, c.windowY, c.windowWidth, c.windowHeight}}};
}

json toJson(const ComparisonLimits& limits) {
    return {{"threshold", limits.threshold},
            {"share", limits.share},
            {"window", limits.window},
            {"mean", limits.mean}};
}

void writeJson(const fs::path& path, const json& contents) {
    fs::create_directories(path.parent_path());
    writeFile(path, contents.dump(2) + "\n");
}

}  // namespace

PictureResult drawAndCompare(const SuitePicture& picture, const fs::path& baseline,
                             const ComparisonLimits& limits) {
    PictureResult result;
    try {
        result.actual = drawSuitePicture(picture);
    } catch (const std::exception& error) {
        result.verdict = "missing picture";
        result.sentence = error.what();
        return result;
    }
    result.glErrors = testContext().takeErrors();
    try {
        result.expected = readPng(baseline);
    } catch (const InputError& error) {
        result.verdict = "missing baseline";
        result.sentence = error.what();
        return result;
    }
    if (result.expected->width != result.actual->width ||
        result.expected->height != result.actual->height) {
        result.verdict = "size mismatch";
        result.sentence = "the picture has " + size(*result.actual) + " pixels, its baseline " +
                          size(*result.expected);
    } else {
        result.comparison = compare(*result.expected, *result.actual, limits.threshold);
        result.verdict = result.comparison->alike(limits) ? "alike" : "mismatch";
        if (result.verdict == "mismatch") result.sentence = describe(*result.comparison);
    }
    return result;
}

void clearPictureResults() {
    fs::remove_all(kReport / "pictures");
}

void writePictureResult(const SuitePicture& picture, const PictureResult& result,
                        const ComparisonLimits& limits, bool onBaselineDriver) {
    const fs::path folder = kReport / "pictures";
    const gl::DeviceInfo& info = testContext().info();
    json contents{{"name", picture.name},
                  {"scene", picture.scene},
                  {"frame", picture.frame},
                  {"verdict", result.verdict},
                  {"holds", result.holds()},
                  {"sentence", result.sentence},
                  {"gl_errors", result.glErrors},
                  {"limits", toJson(limits)},
                  {"baseline_driver", onBaselineDriver},
                  {"renderer", info.renderer},
                  {"gl_version", info.version}};
    if (result.comparison) {
        contents["numbers"] = toJson(*result.comparison);
        fs::create_directories(folder);
        writePng(folder / (picture.name + "-difference.png"),
                 differencePicture(*result.expected, *result.actual, *result.comparison));
    }
    writeJson(folder / (picture.name + ".json"), contents);
    if (result.expected) writePng(folder / (picture.name + "-expected.png"), *result.expected);
    if (result.actual) writePng(folder / (picture.name + "-actual.png"), *result.actual);
}

void writeControlResult(const std::string& picture, const std::string& change,
                        const Comparison& comparison, const ComparisonLimits& limits) {
    std::string name = picture + "-" + change;
    std::replace(name.begin(), name.end(), ' ', '-');
    writeJson(kReport / "controls" / (name + ".json"), {{"picture", picture},
                                                        {"change", change},
                                                        {"seen", !comparison.alike(limits)},
                                                        {"numbers", toJson(comparison)},
                                                        {"limits", toJson(limits)}});
}
