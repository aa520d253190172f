// `sunder compare`, which needs no OpenGL.
#include "app/support/program.hpp"
#include "catch.hpp"
#include "image/comparison.hpp"
#include "image/image.hpp"

using namespace sunder;

namespace {

image::Image gradient(int width, int height) {
    image::Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {4 * x, 5 * y, x + y})
                image.pixels.push_back(static_cast<std::uint8_t>(value));
    return image;
}

}  // namespace

TEST_CASE("App: compare says whether pictures are alike, in words, numbers and a picture") {
    const Workplace place;
    const image::Image a = gradient(60, 40);
    image::Image b = a;
    for (int y = 10; y < 22; ++y)
        for (int x = 20; x < 32; ++x) b.pixels[3 * (60 * y + x) + 1] ^= 64;
    image::writePng(place.path("a.png"), a);
    image::writePng(place.path("b.png"), b);

    const Result same = place.run({"compare", "a.png", "a.png", "--json", "same.json"}, kNoGl);
    INFO(same.command << "\nstderr: " << same.err);
    CHECK(same.exitCode == 0);
    CHECK(contains(same.out, "alike: 0"));
    CHECK(place.readJson("same.json").at("alike") == true);

    const Result other = place.run(
        {"compare", "a.png", "b.png", "--json", "other.json", "--diff", "diff.png"}, kNoGl);
    CHECK(other.exitCode == 1);
    CHECK(other.err.empty());
    CHECK(contains(other.out, "different: 6.00 % of the pixels"));
    const auto report = place.readJson("other.json");
    CHECK(report.at("alike") == false);
    CHECK(report.at("share") == Approx(144.0 / 2400));
    CHECK(report.at("largest") == 64);
    CHECK(report.at("mean") == Approx(64 * 144.0 / 2400));
    CHECK(report.at("worst_window").at("share") == Approx(144.0 / 256));
    // Those that tests/image shows to see what they should.
    const image::ComparisonLimits limits;
    CHECK(report.at("limits").at("threshold") == limits.threshold);
    CHECK(report.at("limits").at("share") == limits.share);
    CHECK(report.at("limits").at("window") == limits.window);
    CHECK(report.at("limits").at("mean") == limits.mean);
    const image::Image diff = image::readPng(place.path("diff.png"));
    CHECK(diff.pixels[3 * (60 * 15 + 25) + 1] == 255);
    CHECK(diff.pixels[0] == 0);

    const Result lenient = place.run(
        {"compare", "a.png", "b.png", "--share", "0.1", "--window", "0.6", "--mean", "4"}, kNoGl);
    CHECK(lenient.exitCode == 0);
}

TEST_CASE(
    "App: compare sees every pixel off by two levels, and a patch, without being told limits") {
    const Workplace place;
    const image::Image a = gradient(60, 40);
    image::Image brighter = a;
    for (std::uint8_t& value : brighter.pixels) value = static_cast<std::uint8_t>(value + 2);
    // 42 of 256 pixels, in a picture large enough for them to be few.
    const image::Image large = gradient(60, 600);
    image::Image patched = large;
    for (int y = 300; y < 306; ++y)
        for (int x = 20; x < 27; ++x) patched.pixels[3 * (60 * y + x)] ^= 64;
    image::writePng(place.path("a.png"), a);
    image::writePng(place.path("brighter.png"), brighter);
    image::writePng(place.path("large.png"), large);
    image::writePng(place.path("patched.png"), patched);
    CHECK(place.run({"compare", "a.png", "brighter.png"}, kNoGl).exitCode == 1);
    CHECK(place.run({"compare", "large.png", "patched.png"}, kNoGl).exitCode == 1);
    CHECK(place.run({"compare", "large.png", "patched.png", "--window", "0.17"}, kNoGl).exitCode ==
          0);
}

TEST_CASE("App: pictures of two sizes are different, not an error") {
    const Workplace place;
    image::writePng(place.path("a.png"), gradient(60, 40));
    image::writePng(place.path("b.png"), gradient(60, 41));
    const Result result = place.run({"compare", "a.png", "b.png"}, kNoGl);
    CHECK(result.exitCode == 1);
    CHECK(contains(result.out, "60 x 40"));
    CHECK(contains(result.out, "60 x 41"));
}

TEST_CASE("App: compare refuses what is no picture, and limits that are none") {
    const Workplace place;
    image::writePng(place.path("a.png"), gradient(60, 40));
    place.write("text.png", "not a picture");
    checkRefused(place.run({"compare", "a.png", "missing.png"}, kNoGl), 2, {"missing.png"});
    checkRefused(place.run({"compare", "text.png", "a.png"}, kNoGl), 2, {"text.png"});
    checkRefused(place.run({"compare", "a.png"}, kNoGl), 2, {"b"});
    checkRefused(place.run({"compare", "a.png", "a.png", "--share", "nan"}, kNoGl), 2,
                 {"--share", "from 0 to 1"});
    checkRefused(place.run({"compare", "a.png", "a.png", "--threshold", "256"}, kNoGl), 2,
                 {"--threshold"});
    checkRefused(place.run({"compare", "a.png", "a.png", "--diff", "no/d.png"}, kNoGl), 2,
                 {"no/d.png"});
    CHECK(place.contents() == std::set<std::string>{"a.png", "text.png"});
}
