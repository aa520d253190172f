#include "view/settings.hpp"

#include <iterator>

#include "core/wording.hpp"
#include "files/system.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "scene/table_reader.hpp"
#include "scene/toml_file.hpp"
#include "sim_gl/solvers.hpp"

namespace sunder::view {

using namespace core;

namespace {

namespace fs = std::filesystem;

using S = Settings;
constexpr Rule<S> kRules[] = {
    {"samples", {1, 8}, &S::samples, "Samples a pixel. More: smoother edges, slower."},
    {"shot", {1, 150, "m/s"}, &S::shot, "Speed that the middle of the spot gets. Shift and wheel."},
    {"push",
     {1, 2000, "m/s²"},
     &S::push,
     "Acceleration of the middle of the spot while you hold the button. Shift and wheel."},
    {"radius",
     {0.02, 2, "m"},
     &S::radius,
     "Size of the spot: the ring around the mouse. Ctrl and wheel."},
    {"interface_scale", {0.5, 4}, &S::interfaceScale, "Size of letters, and of all around them."},
    {"width", {320, 16384}, &S::width, "Of the window, in the screen's coordinates."},
    {"height", {240, 16384}, &S::height, "Of the window, in the screen's coordinates."},
};

template <class Choice, std::size_t Count>
void readChoice(const scene::TableReader& reader, std::string_view key, Choice& value,
                const Choice (&choices)[Count]) {
    std::vector<std::string_view> names;
    for (const Choice choice : choices) names.push_back(toString(choice));
    if (const auto index = reader.readChoice(key, names)) value = choices[*index];
}

std::string inToml(std::string_view text) {
    return '"' + std::string(text) + '"';
}

}  // namespace

std::string_view toString(Tool tool) {
    switch (tool) {
        case Tool::Shoot:
            return "shoot";
        case Tool::Push:
            return "push";
        case Tool::Pull:
            return "pull";
        case Tool::Look:
            return "look";
    }
    return "";
}

std::span<const Rule<Settings>> settingsRules() {
    return kRules;
}

fs::path settingsFile() {
    const fs::path folder = files::settingsFolder();
    return folder.empty() ? folder : folder / "sunder" / "viewer.toml";
}

Settings readSettings(const fs::path& path) {
    Settings settings;
    std::error_code error;
    if (path.empty() || !fs::exists(path, error)) return settings;
    const toml::table document =
        scene::parseToml(scene::readTextFile(path), files::utf8FromPath(path));
    const scene::TableReader reader(
        document, files::utf8FromPath(path), "the settings",
        {"solver", "mesh", "style", "colour", "samples", "vsync", "full_screen", "tool", "shot",
         "push", "radius", "scene_hits", "interface_scale", "panel", "width", "height"});
    std::vector<std::string_view> names;
    for (const sim::SolverInfo& solver : sim_gl::solvers()) names.push_back(solver.name);
    if (const auto index = reader.readChoice("solver", names)) settings.solver = names[*index];
    readChoice(reader, "mesh", settings.mesh, render::kDrawnMeshes);
    readChoice(reader, "style", settings.style, render::kDrawStyles);
    readChoice(reader, "colour", settings.colour, render::kWallColours);
    readChoice(reader, "tool", settings.tool, kTools);
    reader.read("vsync", settings.vsync);
    reader.read("full_screen", settings.fullScreen);
    reader.read("scene_hits", settings.sceneHits);
    reader.read("panel", settings.panel);
    reader.read(settingsRules(), settings);
    return settings;
}

void writeSettings(const fs::path& path, const Settings& settings) {
    if (path.empty()) return;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error)
        throw InputError("cannot make the folder '" + files::utf8FromPath(path.parent_path()) +
                         "': " + error.message());
    const std::pair<const char*, std::string> lines[] = {
        {"solver", inToml(settings.solver)},
        {"mesh", inToml(toString(settings.mesh))},
        {"style", inToml(toString(settings.style))},
        {"colour", inToml(toString(settings.colour))},
        {"samples", std::to_string(settings.samples)},
        {"vsync", settings.vsync ? "true" : "false"},
        {"full_screen", settings.fullScreen ? "true" : "false"},
        {"tool", inToml(toString(settings.tool))},
        {"shot", formatNumber(settings.shot)},
        {"push", formatNumber(settings.push)},
        {"radius", formatNumber(settings.radius)},
        {"scene_hits", settings.sceneHits ? "true" : "false"},
        {"interface_scale", formatNumber(settings.interfaceScale)},
        {"panel", settings.panel ? "true" : "false"},
        {"width", std::to_string(settings.width)},
        {"height", std::to_string(settings.height)},
    };
    std::string text = "# What `sunder view` remembers; it may be deleted.\n";
    for (const auto& [key, value] : lines) text += std::string(key) + " = " + value + "\n";
    files::writeFile(path, text);
}

}  // namespace sunder::view
