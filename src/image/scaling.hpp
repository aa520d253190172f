#pragma once
#include "image/image.hpp"

namespace sunder::image {

/// A picture of `width` x `height` pixels, neither more than it has. Each pixel is the mean, in
/// linear light, of the area that it covers: thin lines and bright spots keep their weight.
Image scaledDown(const Image&, int width, int height);

}  // namespace sunder::image
