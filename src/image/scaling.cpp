#include "image/scaling.hpp"

#include <array>
#include <cassert>

#include "image/srgb.hpp"

namespace sunder::image {
namespace {

/// The part of one source pixel in one pixel of the result.
struct Share {
    int to, from;
    float weight;
};

/// Along one axis; the shares of each result add up to 1.
std::vector<Share> shares(int from, int to) {
    std::vector<Share> result;
    const double size = static_cast<double>(from) / to;  // source pixels per result
    for (int i = 0; i < to; ++i) {
        const double low = i * size, high = i + 1 == to ? from : (i + 1) * size;
        for (int pixel = static_cast<int>(low); pixel < high; ++pixel) {
            const double part = std::min(high, pixel + 1.0) - std::max(low, double(pixel));
            result.push_back({i, pixel, static_cast<float>(part / size)});
        }
    }
    return result;
}

}  // namespace

Image scaledDown(const Image& image, int width, int height) {
    assert(width >= 1 && height >= 1 && width <= image.width && height <= image.height);
    std::array<float, 256> light;
    for (int i = 0; i < 256; ++i) light[i] = linearFromSrgb(static_cast<float>(i) / 255);
    const std::vector<Share> columns = shares(image.width, width);

    std::vector<float> narrow(std::size_t{3} * width * image.height);
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* in = image.pixels.data() + std::size_t{3} * image.width * y;
        float* out = narrow.data() + std::size_t{3} * width * y;
        for (const Share& share : columns)
            for (int channel = 0; channel < 3; ++channel)
                out[3 * share.to + channel] += share.weight * light[in[3 * share.from + channel]];
    }

    const std::size_t row = std::size_t{3} * width;
    std::vector<float> small(row * height);
    for (const Share& share : shares(image.height, height))
        for (std::size_t i = 0; i < row; ++i)
            small[row * share.to + i] += share.weight * narrow[row * share.from + i];

    Image result{width, height, {}};
    result.pixels.reserve(small.size());
    for (const float value : small) result.pixels.push_back(srgbByte(value));
    return result;
}

}  // namespace sunder::image
