#pragma once
#include <array>
#include <string>

#include "image/image.hpp"
#include "render/cell_colours.hpp"

namespace sunder::render {

/// What a bar of colours shows, with its unit: "speed, m/s"; and what stands at its dark end, its
/// middle and its bright end. For stress and speed only.
std::string legendTitle(const ColourKey&);
std::array<std::string, 3> legendNumbers(const ColourKey&);
/// What there is instead of a bar: "12 pieces", or nothing.
std::string legendText(const ColourKey&);
inline bool hasScale(const ColourKey& key) {
    return key.colour == WallColour::Stress || key.colour == WallColour::Speed;
}

/// Draws what the colours mean into a picture's bottom left corner: a bar with numbers and unit, or
/// the number of pieces. Nothing for materials.
void drawLegend(image::Image&, const ColourKey&);

}  // namespace sunder::render
