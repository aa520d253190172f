#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "files/system.hpp"
#include "files/utf8_path.hpp"

namespace sunder::files {

namespace fs = std::filesystem;

std::vector<std::string> commandLine(int count, const char* const* words) {
    return {words + (count > 0), words + count};
}

std::string environmentVariable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::error_code makeNewFile(const fs::path& path) {
    errno = 0;
    std::FILE* file = std::fopen(path.c_str(), "wbx");
    if (!file) return {errno ? errno : EIO, std::generic_category()};
    std::fclose(file);
    return {};
}

fs::path settingsFolder() {
#ifndef __APPLE__
    if (const std::string own = environmentVariable("XDG_CONFIG_HOME"); !own.empty())
        return pathFromUtf8(own);
    constexpr char kBelowHome[] = ".config";
#else
    constexpr char kBelowHome[] = "Library/Application Support";
#endif
    const std::string home = environmentVariable("HOME");
    return home.empty() ? fs::path() : pathFromUtf8(home) / kBelowHome;
}

std::string installCommand(const std::string& program) {
#ifdef __APPLE__
    return "brew install " + program;
#else
    return "apt-get install " + program;
#endif
}

Console::Console() = default;
Console::~Console() = default;

Terminal standardError() {
    return isatty(STDERR_FILENO) ? Terminal::Escapes : Terminal::None;
}

}  // namespace sunder::files
