#include "image/contact_sheet.hpp"

#include <algorithm>
#include <cassert>

#include "image/text.hpp"

namespace sunder::image {

SheetLayout::SheetLayout(int count, int pictureWidth, int pictureHeight) {
    rows = (count + kMostColumns - 1) / kMostColumns;
    columns = (count + rows - 1) / rows;
    tileWidth = std::min(pictureWidth, (kMostWidth + kGap) / columns - kGap);
    tileHeight = std::max(1, pictureHeight * tileWidth / pictureWidth);
}

ContactSheet::ContactSheet(const SheetLayout& layout)
    : layout_(layout), image_{layout.width(), layout.height(), {}} {
    image_.pixels.assign(std::size_t{3} * image_.width * image_.height, 255);
}

void ContactSheet::add(const Image& tile, std::string_view caption) {
    assert(tiles_ < layout_.rows * layout_.columns);
    assert(tile.width == layout_.tileWidth && tile.height == layout_.tileHeight);
    const int left = layout_.left(tiles_), top = layout_.top(tiles_);
    for (int y = 0; y < tile.height; ++y)
        std::copy_n(tile.pixels.begin() + std::ptrdiff_t{3} * tile.width * y, 3 * tile.width,
                    image_.pixels.begin() + 3 * (std::ptrdiff_t{image_.width} * (top + y) + left));
    const int scale = textScale(tile.height);
    drawText(image_, left + 4 * scale, top + 4 * scale, caption, scale);
    ++tiles_;
}

}  // namespace sunder::image
