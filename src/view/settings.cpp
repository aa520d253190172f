#include "view/settings.hpp"

#include <iterator>

#include "files/system.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "scene/table_reader.hpp"
#include "scene/toml_file.hpp"
#include "scene/wording.hpp"
#include "sim_gl/solvers.hpp"

namespace sunder::view {

using namespace core;

namespace {

namespace fs = std::filesystem;

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
    reader.read("samples", settings.samples, {1, 8});
    reader.read("vsync", settings.vsync);
    reader.read("full_screen", settings.fullScreen);
    reader.read("shot", settings.shot, {1, 150, "m/s"});
    reader.read("push", settings.push, {1, 2000, "m/s²"});
    reader.read("radius", settings.radius, {0.02, 2, "m"});
    reader.read("scene_hits", settings.sceneHits);
    reader.read("interface_scale", settings.interfaceScale, {0.5, 4});
    reader.read("panel", settings.panel);
    reader.read("width", settings.width, {320, 16384});
    reader.read("height", settings.height, {240, 16384});
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
        {"shot", scene::formatNumber(settings.shot)},
        {"push", scene::formatNumber(settings.push)},
        {"radius", scene::formatNumber(settings.radius)},
        {"scene_hits", settings.sceneHits ? "true" : "false"},
        {"interface_scale", scene::formatNumber(settings.interfaceScale)},
        {"panel", settings.panel ? "true" : "false"},
        {"width", std::to_string(settings.width)},
        {"height", std::to_string(settings.height)},
    };
    std::string text = "# What `sunder view` remembers; it may be deleted.\n";
    for (const auto& [key, value] : lines) text += std::string(key) + " = " + value + "\n";
    files::writeFile(path, text);
}

}  // namespace sunder::view
