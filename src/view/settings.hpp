#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "core/rule.hpp"
#include "render/cell_colours.hpp"
#include "render/renderer.hpp"

namespace sunder::view {

enum class Tool { Shoot, Push, Pull, Look };
inline constexpr Tool kTools[] = {Tool::Shoot, Tool::Push, Tool::Pull, Tool::Look};
std::string_view toString(Tool);

/// What the viewer remembers between runs.
struct Settings {
    std::string solver = "gather";
    render::DrawnMesh mesh = render::DrawnMesh::Display;
    render::DrawStyle style = render::DrawStyle::Solid;
    render::WallColour colour = render::WallColour::Material;
    int samples = 4;  ///< 1, 2, 4 or 8
    bool vsync = true, fullScreen = false;
    Tool tool = Tool::Shoot;
    double shot = 40;                ///< m/s that a shot gives, 1 to 150
    double push = 300;               ///< m/s² of push and pull while the button is held, 1 to 2000
    double radius = 0.3;             ///< m, of the spot, 0.02 to 2
    bool sceneHits = false;          ///< whether a scene's own events push its bodies
    double interfaceScale = 1;       ///< on top of the screen's own, 0.5 to 4
    bool panel = true;               ///< shown
    int width = 1280, height = 720;  ///< of the window when not full screen
};

/// What its numbers may be, in the file and on sliders.
std::span<const core::Rule<Settings>> settingsRules();

/// viewer.toml in the user's folder for settings: $XDG_CONFIG_HOME/sunder or ~/.config/sunder,
/// %APPDATA%\sunder, ~/Library/Application Support/sunder. Empty where the system names none.
std::filesystem::path settingsFile();

/// Throws InputError, as for a scene, when the file is there but says something wrong. No file: the
/// defaults.
Settings readSettings(const std::filesystem::path&);
/// Makes the folder. Throws InputError.
void writeSettings(const std::filesystem::path&, const Settings&);

}  // namespace sunder::view
