#include "scene/object_reader.hpp"

#include <algorithm>
#include <numbers>

#include "scene/limits.hpp"
#include "scene/names.hpp"
#include "scene/overlap_reader.hpp"
#include "scene/wording.hpp"

namespace sunder::scene {

using namespace core;

namespace {

// In the order of ObjectShape.

const Range kCoordinate{-kMaxLength, kMaxLength, "m"};
const Range kSpeed{-1e4, 1e4, "m/s"};
const Range kSpin{-1e4, 1e4, "rad/s"};

void readShape(const TableReader& reader, ObjectDescription& object) {
    reader.require("shape", "one of " + joined(kShapeNames));
    object.shape = static_cast<ObjectShape>(*reader.readChoice("shape", kShapeNames));
    const Range length{1e-3, 1e3, "m"};
    const auto refuse = [&](std::string_view key, std::string_view instead) {
        if (reader.has(key))
            reader.fail(key, "a " + std::string(kShapeNames[static_cast<int>(object.shape)]) +
                                 " has no " + std::string(key) + "; give " + std::string(instead));
    };
    if (object.shape == ObjectShape::Box) {
        refuse("radius", "size");
        refuse("length", "size");
        reader.require("size", "[x, y, z] in m");
        Vec3 size;
        reader.read("size", size, length);
        object.halfSize = size / 2;
        return;
    }
    const bool capsule = object.shape == ObjectShape::Capsule;
    refuse("size", capsule ? "radius and length" : "radius");
    if (!capsule) refuse("length", "radius");
    reader.require("radius", "in m");
    double radius = 0;
    reader.read("radius", radius, length);
    object.halfSize.setConstant(radius);
    if (!capsule) return;
    reader.require("length", "from end to end along its y axis, in m");
    double whole = 0;
    reader.read("length", whole, {2 * radius, 2e3, "m"});
    object.halfSize[1] = whole / 2;
}

Eigen::Quaterniond readOrientation(const TableReader& reader) {
    Vec3 degrees(0, 0, 0);
    reader.read("rotation", degrees, {-360, 360, "degrees"});
    const Vec3 angle = degrees * std::numbers::pi / 180;
    return Eigen::AngleAxisd(angle[2], Vec3::UnitZ()) * Eigen::AngleAxisd(angle[1], Vec3::UnitY()) *
           Eigen::AngleAxisd(angle[0], Vec3::UnitX());
}

void readMotion(const TableReader& reader, ObjectDescription& object) {
    reader.read("fixed", object.fixed);
    if (object.fixed) {
        for (const std::string_view key : {"mass", "velocity", "spin", "hung_from", "drag"})
            if (reader.has(key))
                reader.fail(key, "a fixed object has no " + std::string(key) +
                                     "; leave it out, or leave fixed out");
        reader.require("position", "[x, y, z] in m, of its centre");
    } else {
        reader.require("mass", "in kg, or fixed = true");
        reader.read("mass", object.mass, {1e-6, 1e9, "kg"});
    }
    reader.read("velocity", object.velocity, kSpeed);
    reader.read("spin", object.spin, kSpin);
    reader.read("drag", object.drag, {0, 1e3, "1/s"});
    Vec3 place;
    if (reader.read("position", place, kCoordinate)) object.position = place;
    if (reader.read("hung_from", place, kCoordinate)) {
        reader.require("position", "[x, y, z] in m, of its centre, where it hangs at first");
        if ((place - *object.position).norm() < 1e-3)
            reader.fail("hung_from", "hung_from must be at least 0.001 m from position");
        object.hungFrom = place;
    }
    if (object.position) return;
    for (const std::string_view key : {"velocity", "spin"})
        if (reader.has(key))
            reader.fail(key,
                        "an object without position is not there until an event throws it; "
                        "give position, or " +
                            std::string(key) + " in the event");
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
            reader.fail("name", "there is already an object named " + inQuotes(object.name) +
                                    "; every object needs a name of its own");
        readShape(reader, object);
        object.orientation = readOrientation(reader);
        readMotion(reader, object);
        reader.read("friction", object.friction, {0, 10});
        reader.read("restitution", object.restitution, {0, 1});
        reader.read("colour", object.colour, {0, 1});
        object.mayOverlap = readOverlap(reader);
        object.where = reader.where("position");
        world.objects.push_back(std::move(object));
    }
}

void readThrow(const TableReader& event, WorldDescription& world) {
    ThrowDescription thrown;
    event.require("time", "when it is thrown, in s");
    event.read("time", thrown.time, {0, kMaxTime, "s"});
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
    const ObjectDescription& object = world.objects[thrown.object];
    if (object.fixed) event.fail("object", inQuotes(name) + " is fixed; only others can be thrown");
    if (object.hungFrom)
        event.fail("object", inQuotes(name) +
                                 " hangs from a chain; give it a velocity instead of throwing it");
    event.require("from", "[x, y, z] in m, where its centre is then");
    event.read("from", thrown.from, kCoordinate);
    event.require("velocity", "[x, y, z] in m/s");
    event.read("velocity", thrown.velocity, kSpeed);
    event.read("spin", thrown.spin, kSpin);
    world.throws.push_back(thrown);
}

}  // namespace sunder::scene
