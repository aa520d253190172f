#include "scene/scene_writer.hpp"

#include <algorithm>
#include <set>

#include "core/event.hpp"
#include "core/limits.hpp"
#include "core/names.hpp"
#include "core/orientation.hpp"
#include "core/rules.hpp"
#include "core/wording.hpp"
#include "scene/scene_rules.hpp"

namespace sunder::scene {

using namespace core;

namespace {

/// TOML wants a digit on both sides of a decimal point; "1e12" and "5" it takes for numbers.
std::string text(double value) {
    return formatNumber(value);
}
std::string text(int value) {
    return std::to_string(value);
}
std::string text(bool value) {
    return value ? "true" : "false";
}
std::string text(std::string_view value) {
    std::string quoted = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}
template <class Number>
std::string text(const Eigen::Matrix<Number, 3, 1>& v) {
    return "[" + text(v[0]) + ", " + text(v[1]) + ", " + text(v[2]) + "]";
}

std::string text(const Numbers& numbers) {
    std::string list;
    for (int i = 0; i < numbers.count; ++i)
        list += (i > 0 ? ", " : "") + text(numbers.values[static_cast<std::size_t>(i)]);
    return numbers.count == 1 ? list : "[" + list + "]";
}

/// Lines "key = value", and headings.
class Writer {
  public:
    void heading(const std::string& name) { out_ += "\n" + name + "\n"; }
    template <class Value>
    void add(std::string_view key, const Value& value) {
        out_ += std::string(key) + " = " + text(value) + "\n";
    }
    void addRaw(std::string_view key, const std::string& value) {
        out_ += std::string(key) + " = " + value + "\n";
    }
    std::string take() { return std::move(out_); }

  private:
    std::string out_;
};

/// A name for each of some things, with a number where two share one.
std::vector<std::string> numbered(std::vector<std::string> names) {
    std::set<std::string> taken;
    for (std::string& name : names) {
        const std::string plain = name;
        for (int number = 2; !taken.insert(name).second; ++number)
            name = plain + "-" + std::to_string(number);
    }
    return names;
}

/// A name for each material that a scene may give it: its own, unless it is a path or too long.
std::vector<std::string> namesFor(const std::vector<Material>& materials) {
    std::vector<std::string> names;
    for (const Material& material : materials) {
        std::string name;
        for (const char c : printable(material.name, kMaxName))
            name += c == '/' || c == '\\' || c == '.' || c == '"' ? '-' : c;
        constexpr std::size_t kMostDigits = 5;
        names.push_back(name.empty() || name.size() + kMostDigits > kMaxName ? "material" : name);
    }
    return numbered(std::move(names));
}

/// The names of bodies or objects, and one for each that has none.
template <class Thing>
std::vector<std::string> namesFor(const std::vector<Thing>& things, const std::string& unnamed) {
    std::vector<std::string> names;
    for (const Thing& thing : things) names.push_back(thing.name.empty() ? unnamed : thing.name);
    return numbered(std::move(names));
}

void addMaterial(Writer& out, const Material& material) {
    if (!material.description.empty())
        out.add("description", std::string_view(material.description));
    out.add("law", toString(material.law));
    out.add("fracture", toString(material.fracture));
    out.add("clusters", toString(material.clusters));
    out.add("surface", toString(material.surface));
    for (const Rule<Material>& rule : materialRules()) out.add(rule.key, rule.get(material));
}

void addBody(Writer& out, const BodyDescription& body, const std::string& name,
             const std::vector<std::string>& materials) {
    out.heading("[[body]]");
    out.add("name", std::string_view(name));
    out.add("material", std::string_view(materials[body.material]));
    out.add("size", body.size);
    out.add("cells", body.cells);
    out.add("position", body.position);
    if (const Vec3 degrees = toDegrees(body.orientation); !degrees.isZero(0))
        out.add("rotation", degrees);
    std::string anchors;
    for (const Side side : body.anchors)
        anchors += (anchors.empty() ? "" : ", ") + text(kSideNames[static_cast<int>(side)]);
    out.addRaw("anchor", "[" + anchors + "]");
    if (body.mayOverlap) out.add("overlap", std::string_view("allow"));
    if (!body.present) out.add("present", false);
    for (const RegionDescription& region : body.regions) {
        out.heading("[[body.region]]");
        out.add("from", region.from);
        out.add("to", region.to);
        if (region.material < 0)
            out.add("empty", true);
        else
            out.add("material", std::string_view(materials[region.material]));
    }
}

void addObject(Writer& out, const ObjectDescription& object, const std::string& name) {
    out.heading("[[object]]");
    out.add("name", std::string_view(name));
    out.add("shape", kShapeNames[static_cast<int>(object.shape)]);
    if (object.shape == ObjectShape::Box) {
        out.add("size", Vec3(2 * object.halfSize));
    } else {
        out.add("radius", object.halfSize[0]);
        if (object.shape == ObjectShape::Capsule) out.add("length", 2 * object.halfSize[1]);
    }
    if (object.position) out.add("position", *object.position);
    if (const Vec3 degrees = toDegrees(object.orientation); !degrees.isZero(0))
        out.add("rotation", degrees);
    if (object.fixed) {
        out.add("fixed", true);
    } else {
        out.add("mass", object.mass);
        out.add("drag", object.drag);
        if (object.position) {
            out.add("velocity", object.velocity);
            out.add("spin", object.spin);
        }
        if (object.hungFrom) out.add("hung_from", *object.hungFrom);
    }
    out.add("friction", object.friction);
    out.add("restitution", object.restitution);
    out.add("colour", object.colour);
    if (object.mayOverlap) out.add("overlap", std::string_view("allow"));
}

void addEvents(Writer& out, const WorldDescription& world, const std::vector<std::string>& bodies,
               const std::vector<std::string>& objects) {
    for (const EventDescription& event : world.events) {
        const bool blast = event.body == kEveryBody;
        out.heading("[[event]]");
        out.add("time", event.time);
        out.add("duration", event.duration);
        out.add("kind",
                blast ? std::string_view("blast") : kEventNames[static_cast<int>(event.kind)]);
        if (blast) {
            out.add("outward", event.outward);
            out.add("falloff", event.falloff);
        } else {
            out.add("body", std::string_view(bodies[event.body]));
        }
        out.add("point", event.point);
        out.add("radius", event.radius);
        out.add("vector", event.vector);
    }
    for (const ThrowDescription& thrown : world.throws) {
        out.heading("[[event]]");
        out.add("time", thrown.time);
        out.add("kind", std::string_view("throw"));
        out.add("object", std::string_view(objects[thrown.object]));
        out.add("from", thrown.from);
        out.add("velocity", thrown.velocity);
        out.add("spin", thrown.spin);
    }
}

}  // namespace

std::string writeMaterial(const Material& material) {
    Writer out;
    addMaterial(out, material);
    return out.take();
}

std::string writeScene(const Scene& scene) {
    const WorldDescription& world = scene.world;
    const std::vector<std::string> materials = namesFor(world.materials);
    Writer out;
    out.add("title", std::string_view(scene.title));
    out.add("frames", scene.frames);
    out.add("gravity", world.gravity);
    out.addRaw("seed", std::to_string(world.seed));
    out.heading("[solver]");
    if (scene.autoSubsteps) {
        out.add("substeps", kAuto);
        out.add("max_substeps", scene.maxSubsteps);
    } else {
        out.add("substeps", scene.substeps);
    }
    out.add("fracture_interval", world.fractureInterval);
    out.heading("[ground]");
    out.add("enabled", world.ground);
    out.add("friction", world.groundFriction);
    if (const auto& room = world.room) {
        out.heading("[room]");
        out.addRaw("x", "[" + text(room->x[0]) + ", " + text(room->x[1]) + "]");
        out.addRaw("z", "[" + text(room->z[0]) + ", " + text(room->z[1]) + "]");
        out.add("friction", room->friction);
        if (room->ceiling) out.add("ceiling", *room->ceiling);
    }
    out.heading("[contact]");
    out.add("enabled", world.contact);
    out.add("parting_speed", world.partingSpeed);
    out.heading("[camera]");
    out.add("position", scene.camera.position);
    out.add("target", scene.camera.target);
    out.add("field_of_view", scene.camera.fieldOfView);
    for (std::size_t i = 0; i < materials.size(); ++i) {
        out.heading("[material." + text(std::string_view(materials[i])) + "]");
        addMaterial(out, world.materials[i]);
    }
    const std::vector<std::string> bodies = namesFor(world.bodies, "body"),
                                   objects = namesFor(world.objects, "object");
    for (std::size_t i = 0; i < bodies.size(); ++i)
        addBody(out, world.bodies[i], bodies[i], materials);
    for (std::size_t i = 0; i < objects.size(); ++i) addObject(out, world.objects[i], objects[i]);
    addEvents(out, world, bodies, objects);
    return out.take();
}

}  // namespace sunder::scene
