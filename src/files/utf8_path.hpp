#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace sunder::files {

/// All text in Sunder is UTF-8. On Windows std::filesystem takes text for that of an old code page,
/// so every path comes from text and becomes text here.
std::filesystem::path pathFromUtf8(std::string_view text);

/// For messages, reports and other programs. With '/' between folders on Windows, too, where a path
/// may have both kinds.
std::string utf8FromPath(const std::filesystem::path& path);

}  // namespace sunder::files
