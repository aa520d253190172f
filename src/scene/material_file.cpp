#include "scene/material_file.hpp"

#include "core/names.hpp"
#include "core/wording.hpp"
#include "files/utf8_path.hpp"
#include "scene/limits.hpp"
#include "scene/presets.hpp"
#include "scene/scene.hpp"
#include "scene/toml_file.hpp"

namespace sunder::scene {

using namespace core;

namespace {

/// Files that lead to one another by `base`; more is taken for a circle.
constexpr int kMaxDepth = 8;

/// Reads an enumeration whose values have these names.
template <class Enum>
void readEnum(const TableReader& reader, std::string_view key, Enum& value,
              std::span<const std::string_view> names) {
    if (const auto index = reader.readChoice(key, names)) value = static_cast<Enum>(*index);
}

/// Everything but the name.
Material readMaterial(const TableReader& reader, MaterialLibrary& library, std::string_view self) {
    Material material;
    std::string base;
    if (reader.read("base", base, kMaxReference)) {
        const auto complain = [&](const std::string& problem) { reader.fail("base", problem); };
        material = library.find(base, complain, self);
    }
    // A base whose chunks have weak boundaries keeps them when only the strength inside changes.
    const bool oneStrength = material.boundaryStrength == material.strength;
    reader.read("description", material.description, kMaxDescription);
    readEnum(reader, "law", material.law, kLawNames);
    readEnum(reader, "fracture", material.fracture, kFractureNames);
    readEnum(reader, "clusters", material.clusters, kClusterNames);
    readEnum(reader, "surface", material.surface, kSurfaceNames);
    reader.read(materialRules(), material, true);
    if (reader.has("strength") && !reader.has("boundary_strength") && oneStrength)
        material.boundaryStrength = material.strength;
    return material;
}

Material parseMaterialAt(std::string_view text, const std::string& file,
                         const std::filesystem::path& folder, int depth) {
    const toml::table document = parseToml(text, file);
    const TableReader reader(document, file, "the material", materialKeys());
    MaterialLibrary library(folder, depth);
    Material material = readMaterial(reader, library, {});
    material.name = files::utf8FromPath(files::pathFromUtf8(file).stem());
    return material;
}

}  // namespace

TableReader::Keys materialKeys() {
    TableReader::Keys keys{"description", "base", "law", "fracture", "clusters", "surface"};
    for (const Rule<Material>& rule : materialRules()) keys.push_back(rule.key);
    return keys;
}

void MaterialLibrary::addOwn(const TableReader& scene) {
    for (auto& [name, reader] : scene.namedTables("material", materialKeys(), kMaxMaterials)) {
        if (name.empty() || name.size() > kMaxName || looksLikePath(name) ||
            name != printable(name, kMaxName))
            reader.fail("a material's name must be 1 to " + std::to_string(kMaxName) +
                        " plain characters, without '/' and '\\' and not ending in .toml");
        own_.emplace(name, Own{reader, Own::State::Unread, {}});
    }
    for (auto& [name, own] : own_) resolve(name, own, [](const std::string&) {});
}

const Material& MaterialLibrary::resolve(const std::string& name, Own& own,
                                         const Complain& complain) {
    if (own.state == Own::State::BeingRead)
        complain("base " + inQuotes(name) +
                 " leads back to this material; one of them must stand alone");
    if (own.state == Own::State::Unread) {
        own.state = Own::State::BeingRead;
        own.material = readMaterial(own.reader, *this, name);
        own.material.name = name;
        own.state = Own::State::Read;
    }
    return own.material;
}

Material MaterialLibrary::find(const std::string& name, const Complain& complain,
                               std::string_view self) {
    if (const auto own = own_.find(name); own != own_.end() && name != self)
        return resolve(name, own->second, complain);
    if (depth_ > kMaxDepth)
        complain("more than " + std::to_string(kMaxDepth) +
                 " material files lead to one another by their base; is it a circle?");
    if (const EmbeddedFile* preset = findPreset(PresetKind::Material, name))
        return parseMaterialAt(preset->text, name + ".toml", {}, depth_ + 1);
    if (!looksLikePath(name)) complain(unknown(name));
    const std::filesystem::path path = folder_ / files::pathFromUtf8(name);
    std::string text;
    try {
        text = readTextFile(path);
    } catch (const InputError& error) {
        complain(error.what());
    }
    return parseMaterialAt(text, files::utf8FromPath(path), path.parent_path(), depth_ + 1);
}

std::string MaterialLibrary::unknown(const std::string& name) const {
    std::vector<std::string> own;
    for (const auto& entry : own_) own.push_back(entry.first);
    const std::vector<std::string> presets = presetNames(PresetKind::Material);
    std::vector<std::string> all = own;
    all.insert(all.end(), presets.begin(), presets.end());
    return "material " + inQuotes(name) + " is neither a preset nor a file" +
           (own.empty() ? "" : "; this scene's own: " + joined(own)) +
           "; presets: " + joined(presets) + suggestion(name, all);
}

Material loadMaterial(const std::string& nameOrPath, const std::filesystem::path& folder) {
    return MaterialLibrary(folder).find(
        nameOrPath, [](const std::string& problem) { throw InputError(problem); });
}

Material parseMaterial(std::string_view text, const std::string& file) {
    return parseMaterialAt(text, file, files::pathFromUtf8(file).parent_path(), 0);
}

}  // namespace sunder::scene
