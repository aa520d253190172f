#include "image/comparison.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace sunder::image {
namespace {

constexpr int kAmplification = 16;

int channelDifference(const Image& a, const Image& b, std::size_t pixel) {
    int most = 0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
        most = std::max(most, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
    return most;
}

/// Counts of set pixels in rectangles from the top left corner, one row and column more than the
/// picture has.
class SummedArea {
  public:
    SummedArea(int width, int height)
        : stride_(width + 1), sums_(std::size_t(stride_) * (height + 1), 0) {}
    /// Row by row.
    void set(int x, int y, bool value) {
        at(x + 1, y + 1) = value + at(x, y + 1) + at(x + 1, y) - at(x, y);
    }
    int count(int x, int y, int width, int height) {
        return at(x + width, y + height) - at(x, y + height) - at(x + width, y) + at(x, y);
    }

  private:
    int& at(int x, int y) { return sums_[std::size_t(stride_) * y + x]; }
    int stride_;
    std::vector<int> sums_;
};

void frame(Image& image, int left, int top, int width, int height) {
    const auto mark = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
        std::uint8_t* p = &image.pixels[3 * (std::size_t(y) * image.width + x)];
        p[0] = 255;
        p[1] = 200;
        p[2] = 0;
    };
    for (int x = left - 1; x <= left + width; ++x)
        for (const int y : {top - 1, top + height}) mark(x, y);
    for (int y = top - 1; y <= top + height; ++y)
        for (const int x : {left - 1, left + width}) mark(x, y);
}

}  // namespace

bool Comparison::alike(const ComparisonLimits& limits) const {
    return share <= limits.share && windowShare <= limits.window && mean <= limits.mean;
}

Comparison compare(const Image& a, const Image& b, int threshold) {
    assert(a.width == b.width && a.height == b.height);
    Comparison result;
    SummedArea differing(a.width, a.height);
    std::int64_t sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const int d = channelDifference(a, b, std::size_t(y) * a.width + x);
            sum += d;
            result.largest = std::max(result.largest, d);
            differing.set(x, y, d > threshold);
        }
    const double pixels = double(a.width) * a.height;
    result.mean = static_cast<double>(sum) / pixels;
    result.share = differing.count(0, 0, a.width, a.height) / pixels;

    result.windowWidth = std::min(kComparisonWindow, a.width);
    result.windowHeight = std::min(kComparisonWindow, a.height);
    int worst = -1;
    for (int y = 0; y + result.windowHeight <= a.height; ++y)
        for (int x = 0; x + result.windowWidth <= a.width; ++x) {
            const int count = differing.count(x, y, result.windowWidth, result.windowHeight);
            if (count <= worst) continue;
            worst = count;
            result.windowX = x;
            result.windowY = y;
        }
    result.windowShare = worst / (double(result.windowWidth) * result.windowHeight);
    return result;
}

Image differencePicture(const Image& a, const Image& b, const Comparison& comparison) {
    Image result{a.width, a.height, std::vector<std::uint8_t>(a.pixels.size())};
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        result.pixels[i] = static_cast<std::uint8_t>(
            std::min(255, kAmplification * std::abs(int{a.pixels[i]} - int{b.pixels[i]})));
    if (comparison.windowShare > 0)
        frame(result, comparison.windowX, comparison.windowY, comparison.windowWidth,
              comparison.windowHeight);
    return result;
}

}  // namespace sunder::image
