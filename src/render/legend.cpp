#include "render/legend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "image/rectangle.hpp"
#include "image/srgb.hpp"
#include "image/text.hpp"
#include "render/colour_map.hpp"

namespace sunder {
namespace {

/// A unit of the size of what is measured.
struct ScaledUnit {
    std::string name;
    double size;  ///< in the plain unit
};

ScaledUnit unitFor(const ColourKey& key) {
    if (key.colour == WallColour::Speed) return {"m/s", 1};
    for (const auto& [prefix, size] : {std::pair{"G", 1e9}, {"M", 1e6}, {"k", 1e3}})
        if (key.end >= size * (1 - 1e-9)) return {prefix + std::string("Pa"), size};
    return {"Pa", 1};
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

Colour pixel(const glm::vec3& linear) {
    return {srgbByte(linear.r), srgbByte(linear.g), srgbByte(linear.b)};
}

void drawScale(Image& image, const ColourKey& key, int scale) {
    const ScaledUnit unit = unitFor(key);
    const int margin = 4 * scale, line = (kTextRows + 2) * scale;
    const int length = std::min(120 * scale, image.width - 2 * margin);
    const int left = margin, numbers = image.height - margin - kTextRows * scale;
    const int bottom = numbers - 3 * scale, top = bottom - 7 * scale;

    const int edge = std::max(1, scale / 2);
    fillRectangle(image, left - edge, top - edge, left + length + edge, bottom + edge,
                  {24, 24, 24});
    for (int x = 0; x < length; ++x)
        fillRectangle(image, left + x, top, left + x + 1, bottom,
                      pixel(mapColour((x + 0.5) / length)));

    const std::string what =
        key.colour == WallColour::Stress ? "largest principal stress, " : "speed, ";
    drawText(image, left, top - edge - line, what + unit.name, scale);
    for (const int half : {0, 1, 2}) {
        const std::string text = number(0.5 * half * key.end / unit.size);
        // The first begins at the bar's left end, the last ends at its right one.
        const int x = left + half * (length - textWidth(text, scale)) / 2;
        drawText(image, x, numbers, text, scale);
    }
}

}  // namespace

void drawLegend(Image& image, const ColourKey& key) {
    const int scale = textScale(image.height);
    if (key.colour == WallColour::Stress || key.colour == WallColour::Speed)
        drawScale(image, key, scale);
    if (key.colour == WallColour::Piece)
        drawText(image, 4 * scale, image.height - (4 + kTextRows) * scale,
                 std::to_string(key.pieces) + (key.pieces == 1 ? " piece" : " pieces"), scale);
}

}  // namespace sunder
