#include "render/legend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "image/rectangle.hpp"
#include "image/srgb.hpp"
#include "image/text.hpp"
#include "render/colour_map.hpp"

namespace sunder::render {
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

image::Colour pixel(const glm::vec3& linear) {
    return {image::srgbByte(linear.r), image::srgbByte(linear.g), image::srgbByte(linear.b)};
}

void drawScale(image::Image& image, const ColourKey& key, int scale) {
    const int margin = 4 * scale, line = (image::kTextRows + 2) * scale;
    const int length = std::min(120 * scale, image.width - 2 * margin);
    const int left = margin, numbers = image.height - margin - image::kTextRows * scale;
    const int bottom = numbers - 3 * scale, top = bottom - 7 * scale;

    const int edge = std::max(1, scale / 2);
    image::fillRectangle(image, left - edge, top - edge, left + length + edge, bottom + edge,
                         {24, 24, 24});
    for (int x = 0; x < length; ++x)
        image::fillRectangle(image, left + x, top, left + x + 1, bottom,
                             pixel(mapColour((x + 0.5) / length)));

    image::drawText(image, left, top - edge - line, legendTitle(key), scale);
    const std::array<std::string, 3> values = legendNumbers(key);
    for (const int half : {0, 1, 2}) {
        const std::string& text = values[half];
        // The first begins at the bar's left end, the last ends at its right one.
        const int x = left + half * (length - image::textWidth(text, scale)) / 2;
        image::drawText(image, x, numbers, text, scale);
    }
}

}  // namespace

std::string legendTitle(const ColourKey& key) {
    const char* what = key.colour == WallColour::Stress ? "largest principal stress, " : "speed, ";
    return what + unitFor(key).name;
}

std::array<std::string, 3> legendNumbers(const ColourKey& key) {
    const double end = key.end / unitFor(key).size;
    return {number(0), number(end / 2), number(end)};
}

std::string legendText(const ColourKey& key) {
    if (key.colour != WallColour::Piece) return {};
    return std::to_string(key.pieces) + (key.pieces == 1 ? " piece" : " pieces");
}

void drawLegend(image::Image& image, const ColourKey& key) {
    const int scale = image::textScale(image.height);
    if (hasScale(key)) drawScale(image, key, scale);
    if (const std::string text = legendText(key); !text.empty())
        image::drawText(image, 4 * scale, image.height - (4 + image::kTextRows) * scale, text,
                        scale);
}

}  // namespace sunder::render
