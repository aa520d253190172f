#include "scene/toml_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/types.hpp"
#include "core/wording.hpp"
#include "files/utf8_path.hpp"

namespace sunder::scene {

using namespace core;

namespace {

constexpr int kMaxKeyParts = 16;

/// Skips the string that starts at text[i], returns the index after it.
std::size_t skipString(std::string_view text, std::size_t i) {
    const char quote = text[i];
    const std::string_view three = quote == '"' ? R"(""")" : "'''";
    const bool multiLine = text.substr(i, 3) == three;
    i += multiLine ? 3 : 1;
    while (i < text.size()) {
        if (quote == '"' && text[i] == '\\') {
            i += 2;
        } else if (multiLine && text.substr(i, 3) == three) {
            i += 3;
            // Up to two quotes may stand right before the closing three.
            for (int extra = 0; extra < 2 && i < text.size() && text[i] == quote; ++extra) ++i;
            return i;
        } else if (!multiLine && (text[i] == quote || text[i] == '\n')) {
            return i + 1;
        } else {
            ++i;
        }
    }
    return i;
}

/// toml++ limits how deep values nest but not how many parts a dotted key has, and it destroys its
/// tables recursively: a key of a million parts would overflow the stack.
void checkKeyDepth(std::string_view text, const std::string& file) {
    int line = 1;
    int dots = 0;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            const std::size_t end = std::min(skipString(text, i), text.size());
            for (; i < end; ++i) line += text[i] == '\n';
            continue;
        }
        if (c == '#') {
            while (i < text.size() && text[i] != '\n') ++i;
            continue;
        }
        if (c == '\n') ++line;
        if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}')
            dots = 0;
        if (c == '.' && ++dots >= kMaxKeyParts) {
            throw InputError(printable(file, 300) + ":" + std::to_string(line) +
                             ": a key has too many parts joined by dots; at most " +
                             std::to_string(kMaxKeyParts) + " are allowed");
        }
        ++i;
    }
}

}  // namespace

std::string readTextFile(const std::filesystem::path& path) {
    const std::string intro = "cannot read " + inQuotes(files::utf8FromPath(path)) + ": ";
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw InputError(intro + "it is a folder; name a .toml file in it");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        const int reason = errno;
        throw InputError(intro + (reason ? std::generic_category().message(reason)
                                         : std::string("it cannot be opened")));
    }
    std::string text(kMaxFileSize + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) throw InputError(intro + "reading stopped with an error");
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > kMaxFileSize)
        throw InputError(intro + "it is larger than 4 MiB; is it a scene or material file?");
    return text;
}

toml::table parseToml(std::string_view text, const std::string& file) {
    if (text.size() > kMaxFileSize)
        throw InputError(printable(file, 300) + ": the text is larger than 4 MiB");
    checkKeyDepth(text, file);
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw InputError(printable(file, 300) + ":" + std::to_string(error.source().begin.line) +
                         ": not valid TOML: " + printable(error.description(), 300));
    }
}

bool looksLikePath(std::string_view name) {
    return name.find_first_of("/\\") != std::string_view::npos || name.ends_with(".toml");
}

}  // namespace sunder::scene
