#pragma once
#include <filesystem>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sunder::app {

/// An option, or an argument, that names a file or folder; `path` must outlive the command.
CLI::Option* addPath(CLI::App& command, const std::string& name, std::filesystem::path& path,
                     const std::string& description);

/// For CLI::Option::check(): what is wrong with `text`, if it is to name a folder that is there.
std::string checkFolder(const std::string& text);

}  // namespace sunder::app
