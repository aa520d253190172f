#include "app/picture_size.hpp"

#include <charconv>

#include "core/types.hpp"

namespace sunder::app {

using namespace core;

std::pair<int, int> parsePictureSize(const std::string& text) {
    // Not sscanf: it takes 4294967456 for 160.
    int w = 0, h = 0;
    const char *begin = text.data(), *end = begin + text.size();
    const auto width = std::from_chars(begin, end, w);
    const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = separated ? std::from_chars(width.ptr + 1, end, h) : width;
    if (!separated || height.ec != std::errc() || height.ptr != end || w < 16 || h < 16 ||
        w > 8192 || h > 8192)
        throw InputError("--size: '" + text +
                         "' is not WIDTHxHEIGHT with both from 16 to 8192, for example 1280x720");
    return {w, h};
}

}  // namespace sunder::app
