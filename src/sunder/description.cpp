#include "scene/scene.hpp"
#include "sunder/convert.hpp"
#include "sunder/guard.hpp"

namespace sunder {

Result<Material> Material::preset(std::string_view name) {
    return guarded([&]() -> Result<Material> {
        for (const scene::PresetInfo& known : scene::materialPresets())
            if (known.name == name) return fromCore(scene::loadMaterial(known.name));
        std::string names;
        for (const scene::PresetInfo& known : scene::materialPresets())
            names += (names.empty() ? "" : ", ") + known.name;
        return Error{Error::Code::Input, "there is no material '" + std::string(name) +
                                             "'; those that come with Sunder are " + names};
    });
}

std::vector<std::string> Material::presetNames() {
    std::vector<std::string> names;
    for (const scene::PresetInfo& known : scene::materialPresets()) names.push_back(known.name);
    return names;
}

Result<Material> Material::load(std::string_view path) {
    return guarded([&]() -> Result<Material> {
        return fromCore(scene::loadMaterialFile(std::string(path)));
    });
}

Result<WorldDesc> WorldDesc::preset(std::string_view name) {
    return guarded([&]() -> Result<WorldDesc> {
        std::string names;
        for (const scene::PresetInfo& known : scene::scenePresets()) {
            if (known.name == name) return fromCore(scene::loadScene(known.name).world);
            names += (names.empty() ? "" : ", ") + known.name;
        }
        return Error{Error::Code::Input, "there is no scene '" + std::string(name) +
                                             "'; those that come with Sunder are " + names};
    });
}

Result<WorldDesc> WorldDesc::load(std::string_view path) {
    return guarded([&]() -> Result<WorldDesc> {
        return fromCore(scene::loadSceneFile(std::string(path)).world);
    });
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
