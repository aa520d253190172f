#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/world.hpp"

namespace sunder::scene {

struct CameraDescription {
    core::Vec3 position{0, 1.6, 5};  ///< m
    core::Vec3 target{0, 1, 0};      ///< m
    double fieldOfView = 45;         ///< degrees, vertical, 1 to 170

    bool operator==(const CameraDescription&) const = default;
};

/// A scene file, read and checked. `world.step` is 1/(60·substeps).
struct Scene {
    std::string name;   ///< the preset's name, or the file's without folder and ending
    std::string title;  ///< one line, for `sunder list`
    int frames = 120;   ///< how long `sunder run` runs by default, in frames of 1/60 s, 1 to 1e6
    int substeps = 50;  ///< per 1/60 s, 1 to 10000
    /// `substeps = "auto"`: as many as its materials need, at most maxSubsteps (chooseSubsteps()).
    bool autoSubsteps = false;
    int maxSubsteps = 5000;  ///< 1 to 10000
    core::WorldDescription world;
    CameraDescription camera;
    bool ownCamera = false;  ///< its file says where the camera is
};

/// Where they are automatic, as many substeps as the materials need as they are now
/// (core/substeps.hpp); and the step that follows.
void chooseSubsteps(Scene& scene);

/// Reads a scene: a preset's name, or a path to a TOML file (anything with a '/', '\' or ending in
/// ".toml"). Material files a scene names are sought beside it. Throws InputError: "FILE:LINE:
/// FIELD …", what is wrong, what would be right.
Scene loadScene(const std::string& nameOrPath);

/// The same from text, for presets, tests and the fuzzer. `file` is the name used in messages;
/// `folder` is where relative paths start.
Scene parseScene(std::string_view text, const std::string& file,
                 const std::filesystem::path& folder);

/// Reads a material: a preset's name or a path. Relative paths start at `folder`.
core::Material loadMaterial(const std::string& nameOrPath,
                            const std::filesystem::path& folder = {});
core::Material parseMaterial(std::string_view text, const std::string& file);

struct PresetInfo {
    std::string name;
    std::string title;
};
std::vector<PresetInfo> scenePresets();     ///< sorted by name
std::vector<PresetInfo> materialPresets();  ///< sorted by name

}  // namespace sunder::scene
