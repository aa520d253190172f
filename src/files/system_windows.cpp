// clang-format off
#include <windows.h>
#include <shellapi.h>
// clang-format on
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <memory>

#include "files/system.hpp"
#include "files/utf16_windows.hpp"
#include "files/utf8_path.hpp"

namespace sunder::files {

namespace fs = std::filesystem;

std::vector<std::string> commandLine(int, const char* const*) {
    int count = 0;
    const std::unique_ptr<wchar_t*, decltype(&LocalFree)> words(
        CommandLineToArgvW(GetCommandLineW(), &count), LocalFree);
    std::vector<std::string> arguments;
    for (int i = 1; i < count; ++i) arguments.push_back(utf8FromUtf16(words.get()[i]));
    return arguments;
}

std::string environmentVariable(const char* name) {
    const wchar_t* value = _wgetenv(utf16FromUtf8(name).c_str());
    return value ? utf8FromUtf16(value) : "";
}

std::error_code makeNewFile(const fs::path& path) {
    errno = 0;
    const int file = _wopen(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL, _S_IREAD | _S_IWRITE);
    if (file < 0) return {errno ? errno : EIO, std::generic_category()};
    _close(file);
    return {};
}

fs::path settingsFolder() {
    return pathFromUtf8(environmentVariable("APPDATA"));
}

std::string installCommand(const std::string& program) {
    return "winget install " + program;
}

Console::Console() : codePage_(GetConsoleOutputCP()) {
    SetConsoleOutputCP(CP_UTF8);
    const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode = 0;
    if (!GetConsoleMode(console, &mode)) return;
    mode_ = mode;
    SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

Console::~Console() {
    if (codePage_) SetConsoleOutputCP(codePage_);
    if (mode_) SetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), mode_);
}

Terminal standardError() {
    if (!_isatty(_fileno(stderr))) return Terminal::None;
    DWORD mode = 0;
    const bool known = GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
    return known && (mode & ENABLE_VIRTUAL_TERMINAL_PROCESSING) ? Terminal::Escapes
                                                                : Terminal::Plain;
}

}  // namespace sunder::files
