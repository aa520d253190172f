#include "app/run_options.hpp"

#include <CLI/CLI.hpp>
#include <charconv>

#include "app/output_path.hpp"
#include "app/sheet_frames.hpp"

namespace sunder::app {
namespace {

/// CLI11 alone takes -1 for 2^64 - 1. Says what is wrong, if anything.
std::string checkSeed(const std::string& text) {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, seed);
    if (result.ec == std::errc() && result.ptr == end) return {};
    return "'" + text + "' is not a whole number from 0 to 18446744073709551615";
}

/// What is drawn, and where it goes.
void addPictureOptions(CLI::App& command, RunOptions& options) {
    command.add_option("--size", options.size, "of pictures")
        ->type_name("WxH")
        ->capture_default_str();
    command
        .add_option("--frames-png", options.pngEvery,
                    "a picture every so many frames, and of the last; 0: none")
        ->check(CLI::Range(0, 1000000))
        ->type_name("EVERY")
        ->capture_default_str();
    command
        .add_option("--video", options.video,
                    "every frame, by ffmpeg, at --fps; the ending says which kind, such as .mp4")
        ->type_name("FILE");
    CLI::Option* sheet = command
                             .add_option("--contact-sheet", options.contactSheet,
                                         "frames side by side in one picture, each with its time")
                             ->type_name("FILE.png");
    command
        .add_option("--sheet-times", options.sheetTimes,
                    "times of its frames, s, with commas (default: up to " +
                        std::to_string(kSheetFrames) + " from the first event or throw on)")
        ->delimiter(',')
        ->needs(sheet)
        ->type_name("S,S,...");
    command
        .add_option("--mesh", options.mesh,
                    "what is drawn of walls: display (torn edges) or simulation (tetrahedra)")
        ->check(CLI::IsMember({"display", "simulation"}))
        ->capture_default_str();
    command
        .add_option("--style", options.style, "how walls are drawn: solid, wireframe or overlay")
        ->check(CLI::IsMember({"solid", "wireframe", "overlay"}))
        ->capture_default_str();
    std::vector<std::string> colours;
    for (const WallColour colour : kWallColours) colours.emplace_back(toString(colour));
    command
        .add_option("--colour", options.colour,
                    "what the colour of walls shows: material, or with a legend stress, speed or "
                    "piece")
        ->check(CLI::IsMember(colours))
        ->capture_default_str();
}

}  // namespace

void addRunOptions(CLI::App& command, RunOptions& options) {
    command.add_option("scene", options.scene, "a preset's name (see: sunder list) or a TOML file")
        ->required()
        ->type_name("SCENE");
    command.add_option("--solver", options.solver, "see: sunder list")->capture_default_str();
    command.add_option("--frames", options.frames, "how many frames (default: the scene's)")
        ->check(CLI::Range(1, 1000000));
    command.add_option("--fps", options.fps, "frames per second of simulated time, 1 to 1000")
        ->capture_default_str();
    command.add_option("--seed", options.seed, "of the strength map (default: the scene's)")
        ->check(checkSeed, "");
    command
        .add_option("--out", options.out,
                    "folder for pictures and report.json (default: out/SCENE)")
        ->type_name("DIR");
    addPictureOptions(command, options);
    command.add_option("--state", options.state, "write the last state as .vtu (ParaView)")
        ->type_name("FILE.vtu");
    command.add_option("--json", options.json, "also write the report here")->type_name("FILE");
}

void checkRunOptions(const RunOptions& options) {
    if (!(options.fps >= 1 && options.fps <= 1000))  // CLI::Range lets nan through
        throw InputError("--fps: it must be from 1 to 1000");
    for (const std::string& path :
         {options.json, options.state, options.video, options.contactSheet})
        checkWritable(path, options.out);
    if (!options.contactSheet.empty() && !options.contactSheet.ends_with(".png"))
        throw InputError("--contact-sheet: '" + options.contactSheet +
                         "' is written as a PNG picture and must end in .png");
}

RenderSettings renderSettings(const RunOptions& options) {
    RenderSettings settings;
    // Not sscanf: it takes 4294967456 for 160.
    const char *text = options.size.data(), *end = text + options.size.size();
    const auto width = std::from_chars(text, end, settings.width);
    const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = separated ? std::from_chars(width.ptr + 1, end, settings.height) : width;
    if (!separated || height.ec != std::errc() || height.ptr != end || settings.width < 16 ||
        settings.height < 16 || settings.width > 8192 || settings.height > 8192)
        throw InputError("--size: '" + options.size +
                         "' is not WIDTHxHEIGHT with both from 16 to 8192, for example 1280x720");
    if (options.mesh == "simulation") settings.mesh = DrawnMesh::Simulation;
    if (options.style == "wireframe") settings.style = DrawStyle::Wireframe;
    if (options.style == "overlay") settings.style = DrawStyle::Overlay;
    return settings;
}

WallColour wallColour(const RunOptions& options) {
    for (const WallColour colour : kWallColours)
        if (toString(colour) == options.colour) return colour;
    return WallColour::Material;
}

}  // namespace sunder::app
