#pragma once
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace sunder {

/// 8-bit sRGB picture, RGB interleaved, rows from top to bottom.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;  ///< 3·width·height
};

/// No picture that is read or drawn may have more pixels.
inline constexpr std::int64_t kMaxPixels = 1 << 26;

/// Writes a PNG under a temporary name and renames it: never a half-written file under `path`.
/// Throws InputError.
void writePng(const std::filesystem::path& path, const Image&);

/// Reads a PNG (any channel count, alpha dropped; 16 bits become 8). Throws InputError naming the
/// file when it is not one, or has more than kMaxPixels.
Image readPng(const std::filesystem::path& path);

/// Writes text or bytes under a temporary name in the same folder, then renames. Throws InputError
/// naming path and reason.
void writeFileAtomically(const std::filesystem::path& path, std::string_view contents);

}  // namespace sunder
