// When two pictures are alike.
#include "image/comparison.hpp"

#include "catch.hpp"
#include "support/worlds.hpp"

using namespace sunder;

namespace {

image::Image grey(int width, int height, int level = 100) {
    return {width, height,
            std::vector<std::uint8_t>(std::size_t{3} * width * height,
                                      static_cast<std::uint8_t>(level))};
}

void add(image::Image& image, int x, int y, int channel, int levels) {
    std::uint8_t& value = image.pixels[3 * (std::size_t{1} * image.width * y + x) + channel];
    value = static_cast<std::uint8_t>(value + levels);
}

}  // namespace

TEST_CASE("A picture is like itself", "[comparison]") {
    const image::Image a = grey(50, 30);
    const image::Comparison c = image::compare(a, a, 0);
    CHECK(c.share == 0);
    CHECK(c.mean == 0);
    CHECK(c.largest == 0);
    CHECK(c.windowShare == 0);
    CHECK(c.alike({.threshold = 0, .share = 0, .window = 0, .mean = 0}));
}

TEST_CASE("The figures of a comparison, counted by hand", "[comparison]") {
    const image::Image a = grey(40, 25);
    image::Image b = a;
    add(b, 3, 4, 0, 9);      // over the threshold in one channel
    add(b, 3, 4, 1, 2);      // less: the largest channel counts
    add(b, 30, 20, 2, -20);  // far from it
    add(b, 31, 20, 2, -20);
    add(b, 0, 24, 1, 8);  // not over it
    const image::Comparison c = image::compare(a, b, 8);
    CHECK(c.share == Approx(3.0 / 1000));
    CHECK(c.mean == Approx((9 + 20 + 20 + 8) / 1000.0));
    CHECK(c.largest == 20);
    CHECK(c.windowShare == Approx(2.0 / 256));
    CHECK((c.windowX <= 30 && c.windowX + c.windowWidth > 31));
    CHECK((c.windowY <= 20 && c.windowY + c.windowHeight > 20));
    CHECK(image::compare(b, a, 8).share == c.share);
}

TEST_CASE("Scattered noise passes where a cluster of as many pixels does not", "[comparison]") {
    const image::Image a = grey(320, 200);
    image::Image noise = a, cluster = a;
    Random random(5);
    const int count = 100;  // 0.16 % of the pixels
    for (int i = 0; i < count; ++i) {
        add(noise, static_cast<int>(160 + 159 * random()), static_cast<int>(100 + 99 * random()), 0,
            30);
        add(cluster, 50 + i % 10, 70 + i / 10, 0, 30);
    }
    const image::ComparisonLimits limits;
    CHECK(image::compare(a, noise, limits.threshold).alike(limits));
    CHECK_FALSE(image::compare(a, cluster, limits.threshold).alike(limits));
    CHECK(image::compare(a, cluster, limits.threshold).share == Approx(100.0 / 64000));
}

TEST_CASE("Each limit alone makes pictures different", "[comparison]") {
    const image::Image a = grey(320, 200),
                       b = grey(320, 200, 107);  // 7 levels: under the threshold
    const image::Comparison darker = image::compare(a, b, 8);
    CHECK(darker.share == 0);
    CHECK(darker.mean == Approx(7));
    CHECK_FALSE(darker.alike({}));
    CHECK(darker.alike({.mean = 7}));

    image::Image spread = a;  // every fifteenth pixel: 6.7 % everywhere
    for (int i = 0; i < 320 * 200; i += 15) add(spread, i % 320, i / 320, 1, 9);
    const image::Comparison many = image::compare(a, spread, 8);
    CHECK(many.windowShare < 0.1);
    CHECK_FALSE(many.alike({}));
    CHECK(many.alike({.share = 0.07}));
}

TEST_CASE("Pictures smaller than a window have one", "[comparison]") {
    const image::Image a = grey(3, 20);
    image::Image b = a;
    add(b, 1, 19, 0, 50);
    const image::Comparison c = image::compare(a, b, 8);
    CHECK(c.windowWidth == 3);
    CHECK(c.windowHeight == 16);
    CHECK(c.windowY == 4);
    CHECK(c.windowShare == Approx(1.0 / 48));
}

TEST_CASE("The difference picture shows differences times 16 and frames the worst window",
          "[comparison]") {
    const image::Image a = grey(60, 40);
    image::Image b = a;
    add(b, 30, 20, 0, 3);
    add(b, 31, 20, 1, 40);
    const image::Comparison c = image::compare(a, b, 8);
    const image::Image d = image::differencePicture(a, b, c);
    const auto pixel = [&](int x, int y) { return &d.pixels[3 * (std::size_t{60} * y + x)]; };
    CHECK(pixel(30, 20)[0] == 48);
    CHECK(pixel(30, 20)[1] == 0);
    CHECK(pixel(31, 20)[1] == 255);
    CHECK(pixel(59, 39)[0] == 0);
    CHECK(pixel(c.windowX - 1, c.windowY)[0] == 255);
    CHECK(pixel(c.windowX + 16, c.windowY + 5)[1] == 200);
}
