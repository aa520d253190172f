#pragma once
#include <vector>

#include "gl/objects.hpp"

namespace sunder::gl {

/// What a vertex shader reads at a location: floats, or whole numbers as they are.
struct Attribute {
    GLuint location;
    GLint components;
    GLenum type;         ///< GL_FLOAT, GL_INT or GL_UNSIGNED_INT
    std::size_t offset;  ///< bytes, in its vertex
};

/// Vertices in a buffer, one after another.
struct VertexInput {
    const Buffer& buffer;
    std::size_t stride;  ///< bytes
    std::vector<Attribute> attributes;
};

/// A vertex array that reads them and, unless null, has these indices. Leaves none bound.
VertexArray makeVertexArray(const std::vector<VertexInput>& inputs,
                            const Buffer* indices = nullptr);

}  // namespace sunder::gl
