#pragma once
#include <string_view>

#include "image/image.hpp"

namespace sunder::image {

/// Pictures of one size in rows, with a thin white line between them.
struct SheetLayout {
    static constexpr int kMostWidth = 1920, kMostColumns = 4, kGap = 4;

    int columns, rows;
    int tileWidth, tileHeight;  ///< px

    /// For `count` pictures of that size: as few rows as kMostColumns allows, rows about equally
    /// full, tiles no larger than the pictures and the sheet no wider than kMostWidth.
    SheetLayout(int count, int pictureWidth, int pictureHeight);

    int width() const { return columns * (tileWidth + kGap) - kGap; }
    int height() const { return rows * (tileHeight + kGap) - kGap; }
    int left(int tile) const { return tile % columns * (tileWidth + kGap); }
    int top(int tile) const { return tile / columns * (tileHeight + kGap); }
};

/// A sheet that fills tile by tile.
class ContactSheet {
  public:
    explicit ContactSheet(const SheetLayout&);
    /// The next one: of the layout's tile size. The caption goes into its top left corner.
    void add(const Image& tile, std::string_view caption);
    const Image& image() const { return image_; }

  private:
    SheetLayout layout_;
    int tiles_ = 0;
    Image image_;
};

}  // namespace sunder::image
