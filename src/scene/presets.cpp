#include "scene/presets.hpp"

#include <algorithm>

#include "embedded_presets.hpp"
#include "scene/scene.hpp"

namespace sunder::scene {

using namespace core;

namespace {

/// "scenes/wood.toml" is the scene "wood". Empty: a file of the other kind.
std::string_view presetName(PresetKind kind, std::string_view file) {
    const std::string_view folder = kind == PresetKind::Scene ? "scenes/" : "materials/";
    const std::string_view ending = ".toml";
    if (!file.starts_with(folder) || !file.ends_with(ending)) return {};
    return file.substr(folder.size(), file.size() - folder.size() - ending.size());
}

}  // namespace

const EmbeddedFile* findPreset(PresetKind kind, std::string_view name) {
    for (const EmbeddedFile& file : presets::embeddedFiles())
        if (!name.empty() && presetName(kind, file.name) == name) return &file;
    return nullptr;
}

std::vector<std::string> presetNames(PresetKind kind) {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : presets::embeddedFiles())
        if (const auto name = presetName(kind, file.name); !name.empty()) names.emplace_back(name);
    // "wood.toml" sorts after "wood-thesis.toml", "wood" before "wood-thesis".
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<PresetInfo> scenePresets() {
    std::vector<PresetInfo> result;
    for (const std::string& name : presetNames(PresetKind::Scene))
        result.push_back({name, loadScene(name).title});
    return result;
}

std::vector<PresetInfo> materialPresets() {
    std::vector<PresetInfo> result;
    for (const std::string& name : presetNames(PresetKind::Material))
        result.push_back({name, loadMaterial(name).description});
    return result;
}

}  // namespace sunder::scene
