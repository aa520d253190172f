#pragma once
#include "image/image.hpp"
#include "render/cell_colours.hpp"

namespace sunder {

/// Draws what the colours mean into a picture's bottom left corner: a bar with numbers and unit, or
/// the number of pieces. Nothing for materials.
void drawLegend(Image&, const ColourKey&);

}  // namespace sunder
