#pragma once
#include "image/image.hpp"

namespace sunder {

/// How far two pictures may differ and still be alike. Drivers round differently, here and there by
/// a level or two; a change of what is drawn changes many pixels close together. So scattered noise
/// is let through and a cluster is not.
struct ComparisonLimits {
    int threshold = 8;     ///< levels of 255: a pixel differs when a channel differs by more
    double share = 0.002;  ///< of all pixels that may differ
    double window = 0.25;  ///< of the pixels that may differ in any window
    double mean = 1;       ///< levels: mean over all pixels of the largest channel difference
};

/// Side of the windows, pixels; smaller pictures have one window.
inline constexpr int kComparisonWindow = 16;

struct Comparison {
    double share = 0;  ///< of pixels that differ
    double mean = 0;   ///< levels
    int largest = 0;   ///< levels, largest channel difference of any pixel
    int windowX = 0, windowY = 0, windowWidth = 0, windowHeight = 0;  ///< the worst window, pixels
    double windowShare = 0;                                           ///< of its pixels that differ

    bool alike(const ComparisonLimits&) const;
};

/// Of two pictures of one size.
Comparison compare(const Image& a, const Image& b, int threshold);

/// The differences times 16, on black, with the worst window framed where it differs.
Image differencePicture(const Image& a, const Image& b, const Comparison&);

}  // namespace sunder
