#include <stb_image.h>
#include <stb_image_write.h>

#include <cassert>
#include <fstream>
#include <limits>
#include <memory>
#include <new>
#include <string>

#include "core/types.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "image/image.hpp"
#include "image/stb_memory.hpp"

namespace sunder::image {

using namespace core;

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
    throw InputError(name + ": " + reason);
}

/// A whole file. stb counts bytes in an int.
std::string readFile(const fs::path& path, const std::string& name) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) fail(name, "no such file");
    if (!fs::is_regular_file(status)) fail(name, "not a file, but a PNG picture is wanted");
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) fail(name, "cannot be read: " + error.message());
    if (size > static_cast<std::uintmax_t>(std::numeric_limits<int>::max()))
        fail(name, "too large for a PNG picture (2 GiB at most)");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file || !file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        fail(name, "cannot be read");
    return bytes;
}

/// stb's complaint; it may quote the file's own bytes.
std::string reasonOfStb() {
    const char* reason = stbi_failure_reason();
    std::string text = reason ? reason : "unknown reason";
    for (char& c : text)
        if (c < 0x20 || c > 0x7e) c = '?';
    return text;
}

void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
}

}  // namespace

std::string encodePng(const Image& image) {
    assert(image.width > 0 && image.height > 0);
    assert(image.pixels.size() == std::size_t{3} * image.width * image.height);
    std::string bytes;
    if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.pixels.data(),
                                3 * image.width))
        throw std::bad_alloc();
    return bytes;
}

void writePng(const fs::path& path, const Image& image) {
    files::writeFile(path, encodePng(image));
}

Image readPng(const fs::path& path) {
    const std::string name = files::utf8FromPath(path);
    return decodePng(readFile(path, name), name);
}

Image decodePng(std::string_view bytes, const std::string& name) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());

    Image image;
    int channels = 0;
    if (!stbi_info_from_memory(data, size, &image.width, &image.height, &channels))
        fail(name, "not a PNG picture");
    const std::int64_t pixelCount = std::int64_t{image.width} * image.height;
    if (pixelCount > kMaxPixels)
        fail(name, std::to_string(image.width) + " x " + std::to_string(image.height) +
                       " pixels are too many (" + std::to_string(kMaxPixels) + " at most)");
    // Twice what four channels of 16 bits and the filter of each row need, as stb's buffers double.
    const StbMemoryLimit limit(
        2 * (static_cast<std::size_t>(8 * pixelCount + image.height) + bytes.size()) + (1 << 20));
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 3),
        stbi_image_free);
    if (!pixels && reasonOfStb() == "outofmem")
        fail(name, "too large or damaged: this machine has not enough memory for it");
    if (!pixels) fail(name, "a damaged PNG picture (" + reasonOfStb() + ")");
    image.pixels.assign(pixels.get(), pixels.get() + 3 * static_cast<std::size_t>(pixelCount));
    return image;
}

}  // namespace sunder::image
