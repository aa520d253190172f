#include "core/wording.hpp"
#include "scene/presets.hpp"
#include "scene/scene.hpp"
#include "sunder/convert.hpp"
#include "sunder/guard.hpp"

namespace sunder {

namespace {

/// Why there is no preset of this name.
Error noPreset(scene::PresetKind kind, const char* what, std::string_view name) {
    return {Error::Code::Input, "there is no " + std::string(what) + " '" + std::string(name) +
                                    "'; those that come with Sunder are " +
                                    core::joined(scene::presetNames(kind))};
}

}  // namespace

Result<Material> Material::preset(std::string_view name) {
    return guarded([&]() -> Result<Material> {
        constexpr auto kind = scene::PresetKind::Material;
        if (!scene::findPreset(kind, name)) return noPreset(kind, "material", name);
        return fromCore(scene::loadMaterial(std::string(name)));
    });
}

std::vector<std::string> Material::presetNames() {
    return scene::presetNames(scene::PresetKind::Material);
}

Result<Material> Material::load(std::string_view path) {
    return guarded(
        [&]() -> Result<Material> { return fromCore(scene::loadMaterial(std::string(path))); });
}

Result<WorldDesc> WorldDesc::preset(std::string_view name) {
    return guarded([&]() -> Result<WorldDesc> {
        constexpr auto kind = scene::PresetKind::Scene;
        if (!scene::findPreset(kind, name)) return noPreset(kind, "scene", name);
        return fromCore(scene::loadScene(std::string(name)).world);
    });
}

Result<WorldDesc> WorldDesc::load(std::string_view path) {
    return guarded(
        [&]() -> Result<WorldDesc> { return fromCore(scene::loadScene(std::string(path)).world); });
}

int WorldDesc::addMaterial(Material material) {
    materials.push_back(std::move(material));
    return static_cast<int>(materials.size()) - 1;
}

int WorldDesc::addMaterial(Result<Material> material) {
    if (material) return addMaterial(std::move(*material));
    if (!missing) missing = material.error();
    return addMaterial(Material{});
}

int WorldDesc::addBody(BodyDesc body) {
    bodies.push_back(std::move(body));
    return static_cast<int>(bodies.size()) - 1;
}

int WorldDesc::addObject(Object object) {
    objects.push_back(std::move(object));
    contact = true;
    return static_cast<int>(objects.size()) - 1;
}

Object Object::sphere(double radius) {
    Object object;
    object.size = {2 * radius, 2 * radius, 2 * radius};
    return object;
}

Object Object::box(Vec3 size) {
    Object object;
    object.shape = Shape::Box;
    object.size = size;
    return object;
}

Object Object::capsule(double radius, double length) {
    Object object;
    object.shape = Shape::Capsule;
    object.size = {2 * radius, length, 2 * radius};
    return object;
}

Object Object::kinematic() const {
    Object object = *this;
    object.isKinematic = true;
    return object;
}

Object Object::fixed() const {
    Object object = *this;
    object.isFixed = true;
    return object;
}

Object Object::at(Vec3 place) const {
    Object object = *this;
    object.position = place;
    return object;
}

}  // namespace sunder
