#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/renderer.hpp"

namespace CLI {
class App;
}

namespace sunder::app {

/// The command line of `sunder run`.
struct RunOptions {
    std::string scene;
    std::string solver = "gather";
    std::optional<int> frames;
    double fps = 60;
    std::optional<std::uint64_t> seed;
    std::string size = "1280x720";
    std::filesystem::path out;
    int pngEvery = 20;
    std::filesystem::path video, contactSheet;
    std::vector<double> sheetTimes;  ///< s
    std::string mesh = "display";
    std::string style = "solid";
    std::string colour = "material";
    std::filesystem::path json, state;
};

/// Adds them to the subcommand; `options` must outlive it.
void addRunOptions(CLI::App& command, RunOptions& options);

/// What CLI11 cannot check of one option alone, and whether results can be written where they are
/// wanted. Throws InputError; leaves no file. `out` must be set.
void checkRunOptions(const RunOptions&);

/// Throws InputError.
render::RenderSettings renderSettings(const RunOptions&);
render::WallColour wallColour(const RunOptions&);

}  // namespace sunder::app
