#include "gpu/texel_ranges.hpp"

#include <algorithm>

namespace sunder::gpu {

std::vector<TexelRectangle> rectanglesOf(TexelRange range, int columns) {
    std::vector<TexelRectangle> result;
    for (int first = range.first; first < range.end;) {
        const int x = first % columns, y = first / columns;
        const int rows = x == 0 ? (range.end - first) / columns : 0;
        const int end = rows > 0 ? first + rows * columns : std::min(range.end, (y + 1) * columns);
        result.push_back({x, y, rows > 0 ? columns : x + end - first, y + std::max(rows, 1)});
        first = end;
    }
    return result;
}

TexelRanges::TexelRanges(std::size_t most, const char* what)
    : buffer_(3 * std::max<std::size_t>(1, most) * sizeof(TexelRectangle), nullptr, GL_DYNAMIC_DRAW,
              what),
      texture_(gl::makeBufferTexture(buffer_, GL_RGBA32I, what)) {}

void TexelRanges::set(std::span<const TexelRange> ranges, int columns) {
    std::vector<TexelRectangle> all;
    for (const TexelRange& range : ranges) {
        const std::vector<TexelRectangle> some = rectanglesOf(range, columns);
        all.insert(all.end(), some.begin(), some.end());
    }
    rectangles_ = static_cast<int>(all.size());
    buffer_.write(0, sizeof(TexelRectangle) * all.size(), all.data());
}

}  // namespace sunder::gpu
