// Contact sheets, and what they are made of: pictures scaled down, text.
#include "image/contact_sheet.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>

#include "catch.hpp"
#include "image/rectangle.hpp"
#include "image/scaling.hpp"
#include "image/srgb.hpp"
#include "image/text.hpp"

using namespace sunder;

namespace {

image::Image plain(int width, int height, const image::Colour& colour) {
    image::Image image{width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height)};
    image::fillRectangle(image, 0, 0, width, height, colour);
    return image;
}

image::Colour at(const image::Image& image, int x, int y) {
    const std::uint8_t* p = image.pixels.data() + 3 * (std::ptrdiff_t{image.width} * y + x);
    return {p[0], p[1], p[2]};
}

constexpr image::Colour kBlue{20, 40, 200}, kWhite{255, 255, 255};

struct Extent {
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1, pixels = 0;
};
/// Around all pixels of a colour; right and bottom are the last of them.
Extent extentOf(const image::Image& image, const image::Colour& colour) {
    Extent box;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (at(image, x, y) != colour) continue;
            box.left = std::min(box.left, x);
            box.right = std::max(box.right, x);
            box.top = std::min(box.top, y);
            box.bottom = std::max(box.bottom, y);
            ++box.pixels;
        }
    return box;
}

image::Image written(const std::string& text, int scale) {
    image::Image image = plain(image::textWidth(text, scale) + 20, 60, kBlue);
    image::drawText(image, 10, 20, text, scale);
    return image;
}

double totalLight(const image::Image& image) {
    double sum = 0;
    for (const std::uint8_t value : image.pixels)
        sum += image::linearFromSrgb(static_cast<float>(value) / 255);
    return sum / (3.0 * image.width * image.height);
}

}  // namespace

TEST_CASE("A sheet's tiles fill it row by row, within its width", "[image]") {
    for (const auto& [width, height] : {std::pair{1280, 720}, {160, 90}, {500, 1200}, {16, 16}})
        for (int count = 1; count <= 64; ++count) {
            CAPTURE(width, height, count);
            const image::SheetLayout layout(count, width, height);
            REQUIRE(layout.columns <= image::SheetLayout::kMostColumns);
            REQUIRE(layout.columns * layout.rows >= count);
            REQUIRE(layout.columns * (layout.rows - 1) < count);  // no row without a picture
            REQUIRE(layout.width() <= image::SheetLayout::kMostWidth);
            REQUIRE(layout.tileWidth <= width);
            REQUIRE(layout.tileHeight <= height);
            const double shape = static_cast<double>(height) / width;
            REQUIRE(layout.tileHeight == Approx(shape * layout.tileWidth).margin(1));
            REQUIRE(layout.left(count - 1) + layout.tileWidth <= layout.width());
            REQUIRE(layout.top(count - 1) + layout.tileHeight == layout.height());
        }
    const image::SheetLayout three(3, 960, 540);
    CHECK(three.columns == 3);
    CHECK(three.rows == 1);
    CHECK(three.tileWidth == 637);  // (1920 - 2 * 4) / 3
    const image::SheetLayout five(5, 960, 540);
    CHECK(five.columns == 3);
    CHECK(five.rows == 2);
}

TEST_CASE("Each tile and caption lands in its place", "[image]") {
    const image::SheetLayout layout(5, 200, 190);
    image::ContactSheet sheet(layout);
    const std::array<std::string, 5> captions{"0.00 s", "0.25 s", "0.50 s", "1.75 s", "12.00 s"};
    for (int i = 0; i < 5; ++i)
        sheet.add(plain(200, 190, {20, static_cast<std::uint8_t>(40 * i), 200}), captions[i]);
    const image::Image& image = sheet.image();
    REQUIRE(image.width == 3 * 200 + 2 * image::SheetLayout::kGap);
    REQUIRE(image.height == 2 * 190 + image::SheetLayout::kGap);
    for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        const int left = i % 3 * 204, top = i / 3 * 194;
        image::Image expected = plain(200, 190, {20, static_cast<std::uint8_t>(40 * i), 200});
        image::drawText(expected, 8, 8, captions[i], 2);
        int different = 0;
        for (int y = 0; y < 190; ++y)
            for (int x = 0; x < 200; ++x)
                different += at(image, left + x, top + y) != at(expected, x, y);
        CHECK(different == 0);
    }
    for (const auto& [x, y] : {std::pair{201, 100}, {407, 300}, {100, 191}, {500, 300}})
        CHECK(at(image, x, y) == kWhite);  // the gaps, and where a sixth would be
}

TEST_CASE("Scaled down, a picture keeps its light", "[image]") {
    image::Image checked = plain(8, 6, {0, 0, 0});
    for (int y = 0; y < 6; ++y)
        for (int x = y % 2; x < 8; x += 2)
            image::fillRectangle(checked, x, y, x + 1, y + 1, kWhite);
    const image::Image half = image::scaledDown(checked, 4, 3);
    for (const std::uint8_t value : half.pixels) CHECK(value == 188);  // half the light, not 128

    image::Image spot = plain(97, 61, {3, 3, 3});
    image::fillRectangle(spot, 40, 30, 47, 33, {255, 120, 10});
    for (const auto& [width, height] : {std::pair{97, 61}, {31, 17}, {48, 60}, {7, 61}, {1, 1}}) {
        CAPTURE(width, height);
        const image::Image small = image::scaledDown(spot, width, height);
        REQUIRE(small.pixels.size() == std::size_t{3} * width * height);
        CHECK(totalLight(small) == Approx(totalLight(spot)).epsilon(0.03));
    }
    CHECK(image::scaledDown(spot, 97, 61).pixels == spot.pixels);
    // The spot stays where it is.
    const image::Image small = image::scaledDown(spot, 32, 20);
    CHECK(at(small, 14, 10)[0] > 200);
    CHECK(at(small, 12, 10)[0] < 10);
}

TEST_CASE("Text stands where it is put, white in a dark outline", "[image]") {
    for (const int scale : {1, 2, 3}) {
        CAPTURE(scale);
        const image::Image image = written("gMQ 0.35 s", scale);
        const Extent box = extentOf(image, kWhite);
        CHECK(box.left >= 10);
        CHECK(box.left < 10 + 2 * scale);
        CHECK(box.right < 10 + image::textWidth("gMQ 0.35 s", scale));
        CHECK(box.top >= 20);
        CHECK(box.bottom == 20 + image::kTextRows * scale - 1);  // the g's
        for (int y = box.top; y <= box.bottom; ++y)
            for (int x = box.left; x <= box.right; ++x) {
                if (at(image, x, y) != kWhite) continue;
                for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
                    REQUIRE(at(image, x + dx, y + dy) != kBlue);
            }
        CHECK(box.pixels == scale * scale * extentOf(written("gMQ 0.35 s", 1), kWhite).pixels);
    }
}

TEST_CASE("Every character is drawn whole, and no two letters or digits look alike", "[image]") {
    std::set<std::string> shapes;
    for (char c = '!'; c <= '~'; ++c) {
        CAPTURE(c);
        const int one = extentOf(written(std::string(1, c), 1), kWhite).pixels;
        REQUIRE(one > 0);
        // A buffer that is too small would cut a line short.
        REQUIRE(extentOf(written(std::string(30, c), 1), kWhite).pixels == 30 * one);
        if (!std::isalnum(c)) continue;
        image::Image image = plain(40, 40, kBlue);
        image::drawText(image, 10, 10, std::string(1, c), 2);
        shapes.emplace(image.pixels.begin(), image.pixels.end());
    }
    CHECK(shapes.size() == 26 + 26 + 10);
    CHECK(written("12 \xC2\xB5m", 2).pixels == written("12 ??m", 2).pixels);
    CHECK(extentOf(written("", 2), kWhite).pixels == 0);
}

TEST_CASE("Text is cut off at the picture's edge", "[image]") {
    const image::Image whole = written("0.35 s", 2);
    for (const auto& [x, y] : {std::pair{-15, 20}, {10, -5}, {30, 20}, {10, 52}, {-900, 900}}) {
        CAPTURE(x, y);
        image::Image image = plain(whole.width, whole.height, kBlue);
        image::drawText(image, x, y, "0.35 s", 2);
        int different = 0;
        for (int row = 0; row < image.height; ++row)
            for (int column = 0; column < image.width; ++column) {
                const int fromX = column - x + 10, fromY = row - y + 20;
                const bool inside =
                    fromX >= 0 && fromX < whole.width && fromY >= 0 && fromY < whole.height;
                different += at(image, column, row) != (inside ? at(whole, fromX, fromY) : kBlue);
            }
        CHECK(different == 0);
    }
}
