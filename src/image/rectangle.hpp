#pragma once
#include <algorithm>
#include <array>

#include "image/image.hpp"

namespace sunder::image {

/// 8-bit sRGB.
using Colour = std::array<std::uint8_t, 3>;

/// Pixels from (left, top) up to but without (right, bottom); what lies outside is left out.
inline void fillRectangle(Image& image, int left, int top, int right, int bottom,
                          const Colour& colour) {
    left = std::max(left, 0);
    right = std::min(right, image.width);
    for (int y = std::max(top, 0); y < std::min(bottom, image.height); ++y)
        for (int x = left; x < right; ++x)
            std::copy(colour.begin(), colour.end(),
                      image.pixels.begin() + 3 * (std::ptrdiff_t{image.width} * y + x));
}

}  // namespace sunder::image
