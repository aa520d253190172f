#include "core/wording.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

namespace sunder::core {
namespace {

struct CodePoint {
    std::uint32_t value = 0;
    std::size_t bytes = 0;  ///< 0: not valid UTF-8
};

CodePoint decode(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
    std::uint32_t value = lead & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        value = (value << 6) | (byte(i) & 0x3Fu);
    }
    const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
    const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
    if (overlong || surrogate || value > 0x10FFFF) return {};
    return {value, length};
}

/// Characters that move the cursor, hide themselves or turn the writing direction.
bool mustEscape(std::uint32_t c) {
    return c < 0x20 || (c >= 0x7F && c <= 0x9F) || (c >= 0x200B && c <= 0x200F) ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x2069) || c == 0xFEFF;
}

std::string escaped(const char* format, unsigned value) {
    char buffer[16];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

template <class Name>
std::string joinedNames(std::span<const Name> names) {
    std::string result;
    for (const Name& name : names) {
        if (!result.empty()) result += ", ";
        result += printable(name, 60);
    }
    return result;
}

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        beforeLast = std::exchange(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
    }
    return row[b.size()];
}

template <class Name>
std::string suggestionAmong(std::string_view name, std::span<const Name> candidates) {
    if (name.size() > 60) return {};
    std::size_t best = std::max<std::size_t>(1, name.size() / 3) + 1;
    std::string_view nearest;
    for (const Name& candidate : candidates) {
        const std::size_t distance = editDistance(name, candidate);
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest.empty() ? std::string() : "; did you mean " + inQuotes(nearest) + "?";
}

}  // namespace

std::string printable(std::string_view text, std::size_t maxCharacters) {
    std::string result;
    for (std::size_t count = 0; !text.empty(); ++count) {
        if (count == maxCharacters) return result + "…";
        const CodePoint c = decode(text);
        if (c.bytes == 0) {
            result += escaped("\\x%02x", static_cast<std::uint8_t>(text[0]));
        } else if (mustEscape(c.value)) {
            result += c.value == '\n' ? "\\n" : escaped("\\u%04x", c.value);
        } else {
            result += text.substr(0, c.bytes);
        }
        text.remove_prefix(std::max<std::size_t>(c.bytes, 1));
    }
    return result;
}

std::string inQuotes(std::string_view text) {
    return "'" + printable(text, 60) + "'";
}

std::string formatNumber(double value) {
    if (value == 0) return "0";           // TOML reads "-0" as an integer, which has no sign
    if (std::isnan(value)) return "nan";  // whatever its sign
    char buffer[64];
    const double size = std::abs(value);
    const bool plain = size >= 1e-4 && size < 1e7;
    const auto format = plain ? std::chars_format::fixed : std::chars_format::general;
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, format).ptr;
    std::string text(buffer, end);
    // "1e+12" reads better as "1e12".
    if (const auto plus = text.find("e+"); plus != std::string::npos) text.erase(plus + 1, 1);
    return text;
}

std::string component(std::string_view key, int index) {
    return std::string(key) + ": number " + std::to_string(index + 1);
}

std::string called(std::string_view kind, std::string_view name, std::size_t index) {
    return std::string(kind) + " " + (name.empty() ? std::to_string(index + 1) : inQuotes(name));
}

std::string lineProblem(std::string_view key, std::string_view text, std::size_t maxCharacters) {
    const std::string must = std::string(key) + " must ", but = ", not the text " + inQuotes(text);
    if (text.empty()) return must + "not be empty";
    if (text.size() > maxCharacters)
        return must + "be at most " + std::to_string(maxCharacters) + " characters long" + but;
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    if (std::any_of(text.begin(), text.end(), isControl))
        return must + "be one line without control characters" + but;
    while (!text.empty()) {
        const std::size_t bytes = decode(text).bytes;
        if (bytes == 0) return must + "be valid UTF-8" + but;
        text.remove_prefix(bytes);
    }
    return {};
}

std::string joined(std::span<const std::string> names) {
    return joinedNames(names);
}
std::string joined(std::span<const std::string_view> names) {
    return joinedNames(names);
}

std::string suggestion(std::string_view name, std::span<const std::string> candidates) {
    return suggestionAmong(name, candidates);
}
std::string suggestion(std::string_view name, std::span<const std::string_view> candidates) {
    return suggestionAmong(name, candidates);
}

}  // namespace sunder::core
