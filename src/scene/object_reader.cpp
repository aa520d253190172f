#include "scene/object_reader.hpp"

#include <algorithm>

#include "core/names.hpp"
#include "core/orientation.hpp"
#include "core/wording.hpp"
#include "scene/limits.hpp"
#include "scene/overlap_reader.hpp"
#include "scene/scene_rules.hpp"

namespace sunder::scene {

using namespace core;

namespace {

void readShape(const TableReader& reader, ObjectDescription& object) {
    reader.require("shape", "one of " + joined(kShapeNames));
    object.shape = static_cast<ObjectShape>(*reader.readChoice("shape", kShapeNames));
    const auto refuse = [&](std::string_view key, std::string_view instead) {
        if (reader.has(key))
            reader.fail(key, "a " + std::string(kShapeNames[static_cast<int>(object.shape)]) +
                                 " has no " + std::string(key) + "; give " + std::string(instead));
    };
    if (object.shape == ObjectShape::Box) {
        refuse("radius", "size");
        refuse("length", "size");
        reader.require("size", "[x, y, z] in m");
        reader.read(shapeRules(object.shape), object);
        return;
    }
    const bool capsule = object.shape == ObjectShape::Capsule;
    refuse("size", capsule ? "radius and length" : "radius");
    if (!capsule) refuse("length", "radius");
    reader.require("radius", "in m");
    reader.read(shapeRules(object.shape), object);
    if (!capsule) return;
    reader.require("length", "from end to end along its y axis, in m");
    reader.read(lengthRule(object.halfSize[0]), object);
}

Eigen::Quaterniond readOrientation(const TableReader& reader) {
    RotationDescription degrees;
    reader.read(kRotationRule, degrees);
    return fromDegrees(degrees.rotation);
}

void readMotion(const TableReader& reader, ObjectDescription& object) {
    reader.read("fixed", object.fixed);
    if (!object.fixed) reader.require("mass", "in kg, or fixed = true");
    reader.read(objectRules(), object);
    checkMotion(
        object, [&](std::string_view key) { return reader.has(key); }, reader.complain());
}

int objectNamed(const WorldDescription& world, const std::string& name) {
    for (std::size_t i = 0; i < world.objects.size(); ++i)
        if (world.objects[i].name == name) return static_cast<int>(i);
    return -1;
}

}  // namespace

void readObjects(const TableReader& scene, WorldDescription& world) {
    const TableReader::Keys keys{"name",        "shape",    "radius",   "size",   "length",
                                 "mass",        "position", "rotation", "fixed",  "velocity",
                                 "spin",        "drag",     "friction", "colour", "hung_from",
                                 "restitution", "overlap"};
    for (const TableReader& reader : scene.tables("object", keys, kMaxObjects)) {
        ObjectDescription object;
        reader.require("name", "a name for messages and events");
        reader.read("name", object.name, kMaxName);
        if (objectNamed(world, object.name) >= 0)
            reader.fail("name", nameTaken("object", object.name));
        readShape(reader, object);
        object.orientation = readOrientation(reader);
        readMotion(reader, object);
        object.mayOverlap = readOverlap(reader);
        object.where = reader.where("position");
        world.objects.push_back(std::move(object));
    }
}

void readThrow(const TableReader& event, WorldDescription& world) {
    ThrowDescription thrown;
    event.require("time", "when it is thrown, in s");
    event.require("object", "the name of the object that is thrown");
    std::string name;
    event.read("object", name, kMaxName);
    thrown.object = objectNamed(world, name);
    if (thrown.object < 0) {
        std::vector<std::string> names;
        for (const ObjectDescription& object : world.objects) names.push_back(object.name);
        event.fail("object", "there is no object " + inQuotes(name) +
                                 (names.empty() ? "; the scene has none: add a table [[object]]"
                                                : "; objects: " + printable(joined(names), 500)) +
                                 suggestion(name, names));
    }
    checkThrown(world.objects[thrown.object], event.complain());
    event.require("from", "[x, y, z] in m, where its centre is then");
    event.require("velocity", "[x, y, z] in m/s");
    event.read(throwRules(), thrown);
    world.throws.push_back(thrown);
}

}  // namespace sunder::scene
