#include "gl/pixel_format.hpp"

#include <stdexcept>
#include <string>

namespace sunder::gl {

PixelFormat pixelFormat(GLenum internalFormat) {
    switch (internalFormat) {
        case GL_R8:
            return {1, GL_RED, GL_UNSIGNED_BYTE};
        case GL_RG8:
            return {2, GL_RG, GL_UNSIGNED_BYTE};
        case GL_RGB8:
            return {3, GL_RGB, GL_UNSIGNED_BYTE};
        case GL_SRGB8:
            return {3, GL_RGB, GL_UNSIGNED_BYTE};
        case GL_RGBA8:
            return {4, GL_RGBA, GL_UNSIGNED_BYTE};
        case GL_SRGB8_ALPHA8:
            return {4, GL_RGBA, GL_UNSIGNED_BYTE};
        case GL_R16F:
            return {2, GL_RED, GL_HALF_FLOAT};
        case GL_RG16F:
            return {4, GL_RG, GL_HALF_FLOAT};
        case GL_RGBA16F:
            return {8, GL_RGBA, GL_HALF_FLOAT};
        case GL_R11F_G11F_B10F:
            return {4, GL_RGB, GL_FLOAT};
        case GL_R32F:
            return {4, GL_RED, GL_FLOAT};
        case GL_RG32F:
            return {8, GL_RG, GL_FLOAT};
        case GL_RGB32F:
            return {12, GL_RGB, GL_FLOAT};
        case GL_RGBA32F:
            return {16, GL_RGBA, GL_FLOAT};
        case GL_R8UI:
            return {1, GL_RED_INTEGER, GL_UNSIGNED_BYTE};
        case GL_R16UI:
            return {2, GL_RED_INTEGER, GL_UNSIGNED_SHORT};
        case GL_R32I:
            return {4, GL_RED_INTEGER, GL_INT};
        case GL_RG32I:
            return {8, GL_RG_INTEGER, GL_INT};
        case GL_RGBA32I:
            return {16, GL_RGBA_INTEGER, GL_INT};
        case GL_R32UI:
            return {4, GL_RED_INTEGER, GL_UNSIGNED_INT};
        case GL_RG32UI:
            return {8, GL_RG_INTEGER, GL_UNSIGNED_INT};
        case GL_RGBA32UI:
            return {16, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
        case GL_DEPTH_COMPONENT16:
            return {2, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT};
        case GL_DEPTH_COMPONENT24:
            return {4, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT};
        case GL_DEPTH_COMPONENT32F:
            return {4, GL_DEPTH_COMPONENT, GL_FLOAT};
        case GL_DEPTH24_STENCIL8:
            return {4, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8};
        default:
            throw std::invalid_argument("no entry for GL format " + std::to_string(internalFormat) +
                                        " in pixel_format.cpp");
    }
}

}  // namespace sunder::gl
