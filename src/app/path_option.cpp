#include "app/path_option.hpp"

#include <CLI/CLI.hpp>

#include "files/utf8_path.hpp"

namespace sunder::app {

namespace fs = std::filesystem;

CLI::Option* addPath(CLI::App& command, const std::string& name, fs::path& path,
                     const std::string& description) {
    return command.add_option_function<std::string>(
        name, [&path](const std::string& text) { path = files::pathFromUtf8(text); }, description);
}

std::string checkFolder(const std::string& text) {
    std::error_code error;
    const fs::file_status status = fs::status(files::pathFromUtf8(text), error);
    if (!fs::exists(status)) return "Directory does not exist: " + text;
    if (!fs::is_directory(status)) return "Directory is actually a file: " + text;
    return {};
}

}  // namespace sunder::app
