#include "image/results.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "gpu/test_context.hpp"
#include "image/stored_state.hpp"

using namespace sunder;
using namespace sunder::core;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const fs::path kReport = SUNDER_REPORT;

std::string size(const image::Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

std::string describe(const image::Comparison& c) {
    return "share " + std::to_string(c.share) + ", window " + std::to_string(c.windowShare) +
           " at " + std::to_string(c.windowX) + ", " + std::to_string(c.windowY) + ", mean " +
           std::to_string(c.mean);
}

json toJson(const image::Comparison& c) {
    return {{"share", c.share},
            {"window", c.windowShare},
            {"mean", c.mean},
            {"largest", c.largest},
            {"worst_window", {c.windowX, c.windowY, c.windowWidth, c.windowHeight}}};
}

json toJson(const image::ComparisonLimits& limits) {
    return {{"threshold", limits.threshold},
            {"share", limits.share},
            {"window", limits.window},
            {"mean", limits.mean}};
}

void writeJson(const fs::path& path, const json& contents) {
    fs::create_directories(path.parent_path());
    files::writeFile(path, contents.dump(2) + "\n");
}

/// Draws it into `result`, or says there why not.
bool draw(const SuitePicture& picture, const fs::path& folder, const DrawPicture& drawPicture,
          PictureResult& result) {
    // What others left behind is not this picture's.
    testContext().takeErrors();
    const auto failed = [&result](const char* verdict, const std::string& sentence) {
        result.verdict = verdict;
        result.sentence = sentence;
        return false;
    };
    const fs::path state = stateOf(folder, picture);
    if (picture.storedState() && !fs::exists(state)) {
        result.accept = "tools/update-baselines " + picture.name;
        return failed("missing state", files::utf8FromPath(state) + ": there is no stored state");
    }
    try {
        result.actual = drawPicture(picture, folder);
    } catch (const StateError& error) {
        result.accept = "tools/update-baselines --states " + picture.name;
        failed("damaged state", error.what());
    } catch (const std::exception& error) {
        failed("missing picture", error.what());
    }
    result.glErrors = testContext().takeErrors();
    return result.actual.has_value();
}

void compareWithBaseline(const image::ComparisonLimits& limits, PictureResult& result) {
    const image::Image &expected = *result.expected, &actual = *result.actual;
    if (expected.width != actual.width || expected.height != actual.height) {
        result.verdict = "size mismatch";
        result.sentence =
            "the picture has " + size(actual) + " pixels, its baseline " + size(expected);
        return;
    }
    result.comparison = image::compare(expected, actual, limits.threshold);
    result.verdict = result.comparison->alike(limits) ? "alike" : "mismatch";
    if (!result.holds()) result.sentence = describe(*result.comparison);
}

}  // namespace

PictureResult drawAndCompare(const SuitePicture& picture, const fs::path& folder,
                             const image::ComparisonLimits& limits,
                             const DrawPicture& drawPicture) {
    PictureResult result;
    const auto failed = [&result](const char* verdict, const std::string& sentence) {
        result.verdict = verdict;
        result.sentence = sentence;
    };
    const fs::path baseline = baselineOf(folder, picture);
    if (!draw(picture, folder, drawPicture, result)) {
        // To see what is missing.
        try {
            result.expected = image::readPng(baseline);
        } catch (const InputError&) {
        }
        return result;
    }
    // What solvers make alike has one baseline, which only the picture that it is named after
    // renews.
    const std::string accept =
        picture.ownBaseline() ? "tools/update-baselines " + picture.name : "";
    if (!fs::exists(baseline)) {
        failed("missing baseline", files::utf8FromPath(baseline) + ": there is no baseline");
        result.accept = accept;
    } else {
        try {
            result.expected = image::readPng(baseline);
            compareWithBaseline(limits, result);
        } catch (const InputError& error) {
            failed("damaged baseline", error.what());
        }
        if (!result.holds()) result.accept = accept;
    }
    // Last: a picture drawn with errors is no ground to accept anything, whatever it looks like.
    if (!result.glErrors.empty()) {
        const std::string also = result.holds() ? "" : "; besides: " + result.verdict;
        failed("GL errors", "OpenGL errors while it was drawn" + also);
        result.accept.clear();
    }
    return result;
}

void clearPictureResults() {
    fs::remove_all(kReport / "pictures");
}

void writePictureResult(const SuitePicture& picture, const PictureResult& result,
                        const image::ComparisonLimits& limits, bool onBaselineDriver) {
    const fs::path folder = kReport / "pictures";
    const gl::DeviceInfo& info = testContext().info();
    json contents{{"name", picture.name},         {"scene", picture.scene},
                  {"frame", picture.frame},       {"solver", toString(picture.solver)},
                  {"baseline", picture.baseline}, {"verdict", result.verdict},
                  {"holds", result.holds()},      {"sentence", result.sentence},
                  {"accept", result.accept},      {"gl_errors", result.glErrors},
                  {"limits", toJson(limits)},     {"baseline_driver", onBaselineDriver},
                  {"renderer", info.renderer},    {"gl_version", info.version}};
    if (result.comparison) {
        contents["numbers"] = toJson(*result.comparison);
        fs::create_directories(folder);
        image::writePng(
            folder / (picture.name + "-difference.png"),
            image::differencePicture(*result.expected, *result.actual, *result.comparison));
    }
    writeJson(folder / (picture.name + ".json"), contents);
    if (result.expected)
        image::writePng(folder / (picture.name + "-expected.png"), *result.expected);
    if (result.actual) image::writePng(folder / (picture.name + "-actual.png"), *result.actual);
}

void writeControlResult(const std::string& picture, const std::string& change,
                        const image::Comparison& comparison, const image::ComparisonLimits& limits,
                        bool seen, bool seenByDefault) {
    std::string name = picture + "-" + change;
    std::replace(name.begin(), name.end(), ' ', '-');
    writeJson(kReport / "controls" / (name + ".json"), {{"picture", picture},
                                                        {"change", change},
                                                        {"seen", seen && seenByDefault},
                                                        {"seen_by_default", seenByDefault},
                                                        {"numbers", toJson(comparison)},
                                                        {"limits", toJson(limits)}});
}
