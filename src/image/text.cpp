#include "image/text.hpp"

#include <stb_easy_font.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "image/rectangle.hpp"

namespace sunder::image {
namespace {

/// What the font has; it reads past its tables otherwise.
std::string printable(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c < ' ' || c > '~') c = '?';
    return result;
}

/// As stb_easy_font writes it.
struct Vertex {
    float x, y, z;
    std::uint8_t colour[4];
};
constexpr int kVerticesPerQuad = 4;
constexpr std::size_t kMostQuads = 24;  // of one character; '#', '@' and 'W' have fewer

}  // namespace

int textScale(int pictureHeight) {
    // 7 pixels high where a picture is a thumbnail, else 14 or more.
    return pictureHeight < 180 ? 1 : std::max(2, pictureHeight / 360);
}

int textWidth(std::string_view text, int scale) {
    return scale * stb_easy_font_width(printable(text).data());
}

void drawText(Image& image, int x, int y, std::string_view text, int scale) {
    std::string letters = printable(text);
    std::vector<Vertex> vertices(kVerticesPerQuad * kMostQuads * letters.size());
    const int quads = stb_easy_font_print(0, 0, letters.data(), nullptr, vertices.data(),
                                          static_cast<int>(vertices.size() * sizeof(Vertex)));
    const auto draw = [&](int margin, const Colour& colour) {
        for (int i = 0; i < quads; ++i) {
            const Vertex *low = &vertices[kVerticesPerQuad * i], *high = low + 2;
            const auto place = [scale](float points) {
                return scale * static_cast<int>(std::lround(points));
            };
            fillRectangle(image, x + place(low->x) - margin, y + place(low->y) - margin,
                          x + place(high->x) + margin, y + place(high->y) + margin, colour);
        }
    };
    draw(std::max(1, scale / 2), {24, 24, 24});
    draw(0, {255, 255, 255});
}

}  // namespace sunder::image
