#include "app/run_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <tuple>

#include "app/number_check.hpp"
#include "app/output_folder.hpp"
#include "app/output_path.hpp"
#include "app/path_option.hpp"
#include "app/picture_size.hpp"
#include "app/sheet_frames.hpp"
#include "files/held_signals.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"

namespace sunder::app {

using namespace core;

namespace {

/// As the command line calls them.
template <class Choice, std::size_t Count>
std::vector<std::string> namesOf(const Choice (&choices)[Count]) {
    std::vector<std::string> names;
    for (const Choice choice : choices) names.emplace_back(toString(choice));
    return names;
}

/// The one with this name, which CLI11 has found among them.
template <class Choice, std::size_t Count>
Choice named(const std::string& name, const Choice (&choices)[Count]) {
    return *std::find_if(choices, choices + Count,
                         [&](Choice choice) { return toString(choice) == name; });
}

/// What is drawn, and where it goes.
void addPictureOptions(CLI::App& command, RunOptions& options) {
    command.add_option("--size", options.size, "of pictures")
        ->type_name("WxH")
        ->capture_default_str();
    command
        .add_option("--frames-png", options.pngEvery,
                    "a picture every so many frames, and of the last; 0: none")
        ->check(wholeNumber(0, 1000000))
        ->type_name("EVERY")
        ->capture_default_str();
    addPath(command, "--video", options.video,
            "every frame, by ffmpeg, at --fps; the ending says which kind, such as .mp4")
        ->type_name("FILE");
    CLI::Option* sheet = addPath(command, "--contact-sheet", options.contactSheet,
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
        ->check(CLI::IsMember(namesOf(render::kDrawnMeshes)))
        ->capture_default_str();
    command
        .add_option("--style", options.style, "how walls are drawn: solid, wireframe or overlay")
        ->check(CLI::IsMember(namesOf(render::kDrawStyles)))
        ->capture_default_str();
    command
        .add_option("--colour", options.colour,
                    "what the colour of walls shows: material, or with a legend stress, speed or "
                    "piece")
        ->check(CLI::IsMember(namesOf(render::kWallColours)))
        ->capture_default_str();
}

void checkRunOutputs(const RunOptions& options) {
    const files::HeldSignals held;
    const OutputFolder trial(options.out);
    checkOutputs({{"--json", options.json},
                  {"--state", options.state},
                  {"--video", options.video},
                  {"--contact-sheet", options.contactSheet}});
    files::checkWritable(options.out / "report.json");
}

}  // namespace

void addRunOptions(CLI::App& command, RunOptions& options) {
    command.add_option("scene", options.scene, "a preset's name (see: sunder list) or a TOML file")
        ->required()
        ->type_name("SCENE");
    command.add_option("--solver", options.solver, "see: sunder list")->capture_default_str();
    command
        .add_option("--frames", options.frames,
                    "how many frames, 1 to 1000000 (default: the scene's)")
        ->check(wholeNumber(1, 1000000));
    command.add_option("--fps", options.fps, "frames per second of simulated time, 1 to 1000")
        ->check(number(1, 1000))
        ->capture_default_str();
    command.add_option("--seed", options.seed, "of the strength map (default: the scene's)")
        ->check(wholeNumber(0, UINT64_MAX));
    addPath(command, "--out", options.out,
            "folder for pictures and report.json (default: out/SCENE)")
        ->type_name("DIR");
    addPictureOptions(command, options);
    addPath(command, "--state", options.state, "write the last state as .vtu (ParaView)")
        ->type_name("FILE.vtu");
    addPath(command, "--json", options.json, "also write the report here")->type_name("FILE");
}

void checkRunOptions(const RunOptions& options) {
    checkRunOutputs(options);
    const std::string sheet = files::utf8FromPath(options.contactSheet);
    if (!sheet.empty() && !sheet.ends_with(".png"))
        throw InputError("--contact-sheet: '" + sheet +
                         "' is written as a PNG picture and must end in .png");
}

render::RenderSettings renderSettings(const RunOptions& options) {
    render::RenderSettings settings;
    std::tie(settings.width, settings.height) = parsePictureSize(options.size);
    settings.mesh = named(options.mesh, render::kDrawnMeshes);
    settings.style = named(options.style, render::kDrawStyles);
    return settings;
}

render::WallColour wallColour(const RunOptions& options) {
    return named(options.colour, render::kWallColours);
}

}  // namespace sunder::app
