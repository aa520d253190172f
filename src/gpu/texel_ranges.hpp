#pragma once
#include <span>
#include <vector>

#include "gl/objects.hpp"

namespace sunder::gpu {

/// Texel numbers first .. end − 1, counted row by row.
struct TexelRange {
    int first, end;
};

/// Columns x0 .. x1 − 1 of rows y0 .. y1 − 1.
struct TexelRectangle {
    GLint x0, y0, x1, y1;
};

/// The at most three rectangles that make up a range in a texture of `columns`: what is left of a
/// row, whole rows, the start of a row.
std::vector<TexelRectangle> rectanglesOf(TexelRange range, int columns);

/// The texels that passes fill, on the GPU: gather/texels.vert draws one rectangle per instance.
class TexelRanges {
  public:
    /// For at most `most` ranges.
    TexelRanges(std::size_t most, const char* what);
    /// Ranges must not overlap.
    void set(std::span<const TexelRange> ranges, int columns);
    int rectangles() const { return rectangles_; }
    /// Texture buffer, RGBA32I, one texel per rectangle.
    const gl::Texture& texture() const { return texture_; }

  private:
    int rectangles_ = 0;
    gl::Buffer buffer_;
    gl::Texture texture_;
};

}  // namespace sunder::gpu
