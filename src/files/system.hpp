#pragma once
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace sunder::files {

// What systems do differently for a program that is started from a command line: system_posix.cpp
// and system_windows.cpp.

/// What follows the program's name on its command line.
std::vector<std::string> commandLine(int count, const char* const* words);

/// Of the program's environment; empty where it is not set.
std::string environmentVariable(const char* name);

/// Makes an empty file where there is nothing, whatever others do meanwhile.
std::error_code makeNewFile(const std::filesystem::path&);

/// The user's folder for settings, below which `sunder` has one; empty where the system names none.
std::filesystem::path settingsFolder();

/// A command that installs a program, as this system's users know it.
std::string installCommand(const std::string& program);

/// While it lives, a console takes text for UTF-8 and heeds ANSI's sequences, if it can.
class Console {
  public:
    Console();
    ~Console();  ///< as it was
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

  private:
    [[maybe_unused]] unsigned codePage_ = 0, mode_ = 0;  ///< before, on Windows
};

enum class Terminal {
    None,     ///< a file, a pipe
    Plain,    ///< knows \r and no more
    Escapes,  ///< knows ANSI's sequences
};
/// What standard error is.
Terminal standardError();

}  // namespace sunder::files
