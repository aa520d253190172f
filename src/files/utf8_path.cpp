#include "files/utf8_path.hpp"

#include <algorithm>

namespace sunder::files {

namespace fs = std::filesystem;

fs::path pathFromUtf8(std::string_view text) {
    return std::u8string(text.begin(), text.end());
}

std::string utf8FromPath(const fs::path& path) {
    const std::u8string text = path.u8string();
    std::string result(text.begin(), text.end());
    std::replace(result.begin(), result.end(), static_cast<char>(fs::path::preferred_separator),
                 '/');
    return result;
}

}  // namespace sunder::files
