#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image/suite.hpp"

/// What became of a picture of the suite.
struct PictureResult {
    /// "alike", or one of the failures: "missing state", "damaged state", "missing picture"
    /// (drawing it threw), "GL errors", "missing baseline", "damaged baseline", "size mismatch",
    /// "mismatch".
    std::string verdict;
    std::string sentence;  ///< what is wrong
    std::string accept;    ///< command after which it holds, if it is right as it is; may be empty
    std::optional<sunder::image::Image> expected, actual;
    std::optional<sunder::image::Comparison> comparison;
    std::vector<std::string> glErrors;

    bool holds() const { return verdict == "alike"; }
};

inline sunder::image::Image drawUnchanged(const SuitePicture& picture,
                                          const std::filesystem::path& folder) {
    return drawSuitePicture(picture, folder);
}
using DrawPicture =
    std::function<sunder::image::Image(const SuitePicture&, const std::filesystem::path&)>;
/// Draws it and compares it with its baseline. `folder`: tests/image, or one like it. `draw`: in
/// drawSuitePicture()'s place.
PictureResult drawAndCompare(const SuitePicture&, const std::filesystem::path& folder,
                             const sunder::image::ComparisonLimits&,
                             const DrawPicture& draw = drawUnchanged);

/// Forgets the pictures of earlier runs.
void clearPictureResults();

/// What tools/report shows: a JSON of numbers, limits, verdict and driver, and the PNGs there are.
void writePictureResult(const SuitePicture&, const PictureResult&,
                        const sunder::image::ComparisonLimits&, bool onBaselineDriver);

/// A change that the comparison must see within the suite's limits and within those that `sunder
/// compare` has by default, and whether it did.
void writeControlResult(const std::string& picture, const std::string& change,
                        const sunder::image::Comparison&, const sunder::image::ComparisonLimits&,
                        bool seen, bool seenByDefault);
