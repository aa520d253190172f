#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sunder::image {

/// sRGB to linear light, both 0 to 1 (IEC 61966-2-1).
inline float linearFromSrgb(float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

/// Linear light, cut to 0 to 1, as the 8 bits of a picture.
inline std::uint8_t srgbByte(float light) {
    const float x = std::clamp(light, 0.f, 1.f);
    const float value = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
    return static_cast<std::uint8_t>(255 * value + 0.5f);
}

}  // namespace sunder::image
