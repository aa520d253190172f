#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::image {

/// 8-bit sRGB picture, RGB interleaved, rows from top to bottom.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;  ///< 3·width·height
};

/// No picture that is read or drawn may have more pixels.
inline constexpr std::int64_t kMaxPixels = 1 << 26;

/// As the bytes of a PNG file. Throws std::bad_alloc.
std::string encodePng(const Image&);
/// Throws InputError, as writeFile() does.
void writePng(const std::filesystem::path& path, const Image&);

/// Reads a PNG (any channel count, alpha dropped; 16 bits become 8). Throws InputError naming the
/// file when it is not one, or has more than kMaxPixels.
Image readPng(const std::filesystem::path& path);
/// The same from a file's bytes, less than 2 GiB; `name` is the file's in messages.
Image decodePng(std::string_view bytes, const std::string& name);

}  // namespace sunder::image
