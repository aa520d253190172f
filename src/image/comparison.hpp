#pragma once
#include "image/image.hpp"

namespace sunder::image {

/// How far two pictures may differ and still be alike. Drivers round differently, here and there by
/// a level or two; a change of what is drawn changes many pixels close together. So scattered noise
/// is let through and a cluster is not.
///
/// The numbers lie between what llvmpipe differs from itself by with other vector instructions
/// (0.0002 of all pixels, 0.05 of a window, 0.004 levels at most) and the least change of a picture
/// of 480 x 270 that should be seen: one cell of a wall missing at its far end fills 0.19 of a
/// window and, of all pixels, 0.0004; no bound on all of them could tell it from noise.
/// tests/image/image_suite_test.cpp has changes that these numbers must see.
struct ComparisonLimits {
    int threshold = 8;     ///< levels of 255: a pixel differs when a channel differs by more
    double share = 0.002;  ///< of all pixels that may differ
    double window = 0.15;  ///< of the pixels that may differ in any window
    /// Levels: mean over all pixels of the largest channel difference. Every pixel may be off by
    /// one level, which nobody sees.
    double mean = 1;
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

}  // namespace sunder::image
