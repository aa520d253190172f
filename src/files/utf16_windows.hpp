#pragma once
#include <string>
#include <string_view>

namespace sunder::files {

// Windows's own functions take UTF-16. Those that take text of a code page would take UTF-8 only
// since Windows 10 of 2019, and only where the program's manifest is heeded. What is no text
// becomes U+FFFD.

std::wstring utf16FromUtf8(std::string_view text);
std::string utf8FromUtf16(std::wstring_view text);

}  // namespace sunder::files
