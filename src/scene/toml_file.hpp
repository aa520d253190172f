#pragma once
#include "scene/toml.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace sunder::scene {

/// Files larger than this are refused, in bytes.
inline constexpr std::size_t kMaxFileSize = 4u << 20;

/// The whole file. Throws InputError: "cannot read 'x.toml': No such file or directory".
std::string readTextFile(const std::filesystem::path& path);

/// Throws InputError with `file`, the line and the parser's description when the text is not TOML.
toml::table parseToml(std::string_view text, const std::string& file);

/// A name with a '/' or '\' or the ending ".toml" means a file, not a preset.
bool looksLikePath(std::string_view name);

}  // namespace sunder::scene
