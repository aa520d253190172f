#include "view/recorder.hpp"

#include <algorithm>

namespace sunder::view {

namespace fs = std::filesystem;

Recorder::Recorder(const fs::path& path, int width, int height)
    : width_(width & ~1),
      height_(height & ~1),
      video_((image::VideoFile::check(path, width_, height_, 60), path), width_, height_, 60) {}

bool Recorder::add(const image::Image& image) {
    if ((image.width & ~1) != width_ || (image.height & ~1) != height_) return false;
    ++frames_;
    if (image.width == width_ && image.height == height_) {
        video_.add(image);
        return true;
    }
    image::Image even{width_, height_, {}};
    even.pixels.reserve(std::size_t{3} * width_ * height_);
    for (int row = 0; row < height_; ++row) {
        const auto from = image.pixels.begin() + std::ptrdiff_t{3} * image.width * row;
        even.pixels.insert(even.pixels.end(), from, from + std::ptrdiff_t{3} * width_);
    }
    video_.add(even);
    return true;
}

}  // namespace sunder::view
