#pragma once
#include "gl/functions.hpp"

#include <cstddef>

namespace sunder::gl {

/// What GL wants to know beside a sized internal format.
struct PixelFormat {
    std::size_t bytes;  ///< per texel
    GLenum format;      ///< client format that glTexImage2D accepts with it
    GLenum type;
};

/// Throws std::invalid_argument for a format that Sunder does not use; add it to the table then.
PixelFormat pixelFormat(GLenum internalFormat);

}  // namespace sunder::gl
