#pragma once
#include <string_view>

#include "image/image.hpp"

namespace sunder::image {

/// Rows from the top of a capital to the bottom of a 'g', in units of a text's scale.
inline constexpr int kTextRows = 9;

/// The scale at which text is legible in a picture of that height (pixels), and no larger.
int textScale(int pictureHeight);

/// Pixels, at a scale: pixels per point of the font.
int textWidth(std::string_view, int scale);

/// White with a dark outline, so that it can be read on anything; cut off at the picture's edge.
/// (x, y) is the top left corner of the letters without their outline. One line; what is not
/// printable ASCII shows as '?'.
void drawText(Image&, int x, int y, std::string_view, int scale);

}  // namespace sunder::image
