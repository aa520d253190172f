#include "pictures.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>

#include "catch.hpp"

namespace {

template <class Visit>
double shareOf(const sunder::image::Image& image, const Area& area, Visit&& counts) {
    REQUIRE(area.left >= 0);
    REQUIRE(area.top >= 0);
    REQUIRE(area.width > 0);
    REQUIRE(area.height > 0);
    REQUIRE(area.left + area.width <= image.width);
    REQUIRE(area.top + area.height <= image.height);
    std::int64_t count = 0;
    for (int y = area.top; y < area.top + area.height; ++y)
        for (int x = area.left; x < area.left + area.width; ++x)
            count += counts(3 * (std::size_t(y) * image.width + x));
    return static_cast<double>(count) / (static_cast<double>(area.width) * area.height);
}

}  // namespace

Area sceneOf(const sunder::image::Image& image) {
    return {kPanel, 0, image.width - kPanel, image.height - 60};
}

double sceneDifference(const sunder::image::Image& a, const sunder::image::Image& b) {
    return difference(a, b, sceneOf(a));
}

double difference(const sunder::image::Image& a, const sunder::image::Image& b, const Area& area) {
    REQUIRE(a.width == b.width);
    REQUIRE(a.height == b.height);
    return shareOf(a, area, [&](std::size_t at) {
        int most = 0;
        for (std::size_t i = at; i < at + 3; ++i)
            most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
        return most > 12;
    });
}

double share(const sunder::image::Image& image, const Area& area, int red, int green, int blue) {
    return shareOf(image, area, [&](std::size_t at) {
        return std::abs(image.pixels[at] - red) < 12 &&
               std::abs(image.pixels[at + 1] - green) < 12 &&
               std::abs(image.pixels[at + 2] - blue) < 12;
    });
}

int colours(const sunder::image::Image& image, const Area& area) {
    std::set<int> found;
    shareOf(image, area, [&](std::size_t at) {
        found.insert((image.pixels[at] >> 4) << 8 | (image.pixels[at + 1] >> 4) << 4 |
                     image.pixels[at + 2] >> 4);
        return true;
    });
    return static_cast<int>(found.size());
}

void checkLooksRight(const sunder::image::Image& image, int panel) {
    const Area left{0, 0, panel, image.height};
    CHECK(share(image, left, 27, 28, 32) > 0.3);
    CHECK(share(image, left, 237, 143, 51) > 0.00005);  // thin letters: few have all of it
    CHECK(colours(image, {panel, 0, image.width - panel, image.height}) > 30);
}
