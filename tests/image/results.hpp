#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image/suite.hpp"

/// What became of a picture of the suite.
struct PictureResult {
    /// "alike", or one of four failures: "mismatch", "size mismatch", "missing baseline", "missing
    /// picture".
    std::string verdict;
    std::string sentence;  ///< what is wrong
    std::optional<sunder::Image> expected, actual;
    std::optional<sunder::Comparison> comparison;
    std::vector<std::string> glErrors;

    bool holds() const { return verdict == "alike" && glErrors.empty(); }
};

/// Draws it and compares it with its baseline.
PictureResult drawAndCompare(const SuitePicture&, const std::filesystem::path& baseline,
                             const sunder::ComparisonLimits&);

/// Forgets the pictures of earlier runs.
void clearPictureResults();

/// What tools/report shows: a JSON of numbers, limits, verdict and driver, and the PNGs there are.
void writePictureResult(const SuitePicture&, const PictureResult&, const sunder::ComparisonLimits&,
                        bool onBaselineDriver);

/// A change that the comparison must see, and whether it did.
void writeControlResult(const std::string& picture, const std::string& change,
                        const sunder::Comparison&, const sunder::ComparisonLimits&);
