#include "core/check.hpp"

#include <array>
#include <cmath>
#include <set>

#include "core/cell.hpp"
#include "core/element_law.hpp"
#include "core/event.hpp"
#include "core/limits.hpp"
#include "core/names.hpp"
#include "core/wording.hpp"

namespace sunder::core {
Complain complainAbout(const std::string& thing) {
    return
        [prefix = thing.empty() ? thing : thing + ": "](
            std::string_view, const std::string& problem) { throw InputError(prefix + problem); };
}

namespace {

/// Complaints about one thing of a world.
void checkCount(std::size_t count, std::size_t most, const std::string& what) {
    if (count > most)
        throw InputError("the world has more than " + std::to_string(most) + " " + what +
                         "; use fewer");
}

template <class Enum, std::size_t Count>
void checkChoice(std::string_view key, Enum value, const std::string_view (&names)[Count],
                 const Complain& complain, std::size_t count = Count) {
    const auto index = static_cast<std::int64_t>(value);
    if (index < 0 || index >= static_cast<std::int64_t>(count))
        complain(key, std::string(key) + " must be one of " +
                          joined(std::span<const std::string_view>(names, count)) +
                          ", not number " + std::to_string(index));
}

/// Whether there is such a thing. `none` is allowed besides.
void checkIndex(std::string_view key, int index, std::size_t count, const std::string& things,
                const Complain& complain, bool none = false) {
    if ((none && index == -1) || (index >= 0 && static_cast<std::size_t>(index) < count)) return;
    complain(key, std::string(key) + " must be " + (none ? "-1 or " : "") +
                      "the index of one of the " + std::to_string(count) + " " + things +
                      ", counted from 0, not " + std::to_string(index));
}

/// A name may be empty, but not somebody else's.
void checkName(std::string_view kind, const std::string& name, std::set<std::string_view>& taken,
               const Complain& complain) {
    if (name.empty()) return;
    if (const std::string problem = lineProblem("name", name, kMaxName); !problem.empty())
        complain("name", problem);
    if (!taken.insert(name).second) complain("name", nameTaken(kind, name));
}

void check(const Material& material, const Complain& complain) {
    for (const auto& [key, text, most] :
         {std::tuple{"name", &material.name, kMaxReference},
          std::tuple{"description", &material.description, kMaxDescription}})
        if (!text->empty())
            if (const std::string problem = lineProblem(key, *text, most); !problem.empty())
                complain(key, problem);
    checkChoice("law", material.law, kLawNames, complain);
    checkChoice("fracture", material.fracture, kFractureNames, complain);
    checkChoice("clusters", material.clusters, kClusterNames, complain);
    checkChoice("surface", material.surface, kSurfaceNames, complain);
    checkNumbers(materialRules(), material, complain);
}

void checkOrientation(const Eigen::Quaterniond& orientation, const Complain& complain) {
    // Written so that NaN fails it.
    if (!(std::abs(orientation.norm() - 1) < 1e-6))
        complain("orientation", "orientation must be a quaternion of length 1, not " +
                                    formatNumber(orientation.norm()));
}

void check(const BodyDescription& body, const std::string& name, std::size_t materials) {
    const Complain complain = complainAbout(name);
    checkNumbers(bodyRules(), body, complain);
    checkOrientation(body.orientation, complain);
    std::array<bool, std::size(kSideNames)> anchored{};
    for (const Side side : body.anchors) {
        checkChoice("anchor", side, kSideNames, complain);
        const auto index = static_cast<std::size_t>(side);
        if (anchored[index]) complain("anchor", namedTwice("anchor", kSideNames[index]));
        anchored[index] = true;
    }
    checkIndex("material", body.material, materials, "materials", complain);
    checkCount(body.regions.size(), kMaxRegions, "regions of " + name);
    for (std::size_t i = 0; i < body.regions.size(); ++i) {
        const RegionDescription& region = body.regions[i];
        const Complain about = complainAbout("region " + std::to_string(i + 1) + " of " + name);
        checkNumbers(regionRules(), region, about);
        checkPlace(region, body.cells, about);
        checkIndex("material", region.material, materials, "materials", about, true);
    }
}

void checkBodies(const WorldDescription& world) {
    std::set<std::string_view> names;
    std::int64_t cells = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const BodyDescription& body = world.bodies[i];
        const std::string name = called("body", body.name, i);
        checkName("body", body.name, names, complainAbout(name));
        check(body, name, world.materials.size());
        cells += cellsOf(body.cells);
        if (cells > kMaxCells)
            throw InputError("the world is too large: it has more than " +
                             std::to_string(kMaxCells) + " cells with " + name +
                             "; use fewer or larger cells");
    }
}

/// As World makes them.
void checkLaws(const WorldDescription& world) {
    std::set<std::array<double, 4>> laws;
    for (const BodyDescription& body : world.bodies) {
        const Vec3 edges = body.size.cwiseQuotient(body.cells.cast<double>());
        const auto add = [&](int material) {
            if (material >= 0)
                laws.insert({static_cast<double>(material), edges[0], edges[1], edges[2]});
        };
        add(body.material);
        for (const RegionDescription& region : body.regions) add(region.material);
        checkCount(laws.size(), kMaxElementLaws, "combinations of material and cell size");
    }
}

void check(const ObjectDescription& object, const Complain& complain) {
    checkChoice("shape", object.shape, kShapeNames, complain);
    checkNumbers(shapeRules(object.shape), object, complain);
    const Vec3& half = object.halfSize;
    if (object.shape == ObjectShape::Capsule) checkNumbers(lengthRule(half[0]), object, complain);
    const bool capsule = object.shape == ObjectShape::Capsule;
    if (object.shape != ObjectShape::Box &&
        (half[2] != half[0] || (!capsule && half[1] != half[0])))
        complain("radius", std::string("radius must be the same along x") + (capsule ? "" : ", y") +
                               " and z, not " + formatNumber(half[0]) +
                               (capsule ? "" : ", " + formatNumber(half[1])) + " and " +
                               formatNumber(half[2]) + " m");
    checkOrientation(object.orientation, complain);
    checkNumbers(objectRules(), object, complain);
    const auto given = [&](std::string_view key) {
        if (key == "velocity") return !object.velocity.isZero(0);
        if (key == "spin") return !object.spin.isZero(0);
        if (key == "fixed") return object.fixed;
        return key == "hung_from" && object.hungFrom.has_value();
    };
    checkMotion(object, given, complain);
}

void checkObjects(const WorldDescription& world) {
    checkCount(world.objects.size(), kMaxObjects, "objects");
    if (!world.objects.empty() && !world.contact)
        throw InputError("the world has objects, but cells do not touch: enable contact");
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        const ObjectDescription& object = world.objects[i];
        const Complain complain = complainAbout(called("object", object.name, i));
        checkName("object", object.name, names, complain);
        check(object, complain);
    }
}

void checkEvents(const WorldDescription& world) {
    checkCount(world.events.size(), kMaxEvents, "events");
    checkCount(world.throws.size(), kMaxEvents, "throws");
    for (std::size_t i = 0; i < world.events.size(); ++i) {
        checkEvent(world.events[i], world.bodies.size(),
                   complainAbout("event " + std::to_string(i + 1)));
    }
    for (std::size_t i = 0; i < world.throws.size(); ++i) {
        const ThrowDescription& thrown = world.throws[i];
        const Complain complain = complainAbout("throw " + std::to_string(i + 1));
        checkThrow(thrown, world.objects, complain);
    }
}

std::string triple(const IVec3& v) {
    return "[" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " + std::to_string(v[2]) +
           "]";
}

}  // namespace

void check(const WorldDescription& world) {
    checkNumbers(worldRules(), world, complainAbout({}));
    checkNumbers(solverRules(), world, complainAbout("solver"));
    checkNumbers(groundRules(), world, complainAbout("ground"));
    checkNumbers(contactRules(), world, complainAbout("contact"));
    if (world.room) checkNumbers(roomRules(), *world.room, complainAbout("room"));
    if (world.bodies.empty()) throw InputError("the world has no bodies; add at least one");
    if (world.materials.empty()) throw InputError("the world has no materials; add at least one");
    checkCount(world.bodies.size(), kMaxBodies, "bodies");
    for (std::size_t i = 0; i < world.materials.size(); ++i)
        check(world.materials[i], complainAbout(called("material", world.materials[i].name, i)));
    checkBodies(world);
    checkLaws(world);
    checkObjects(world);
    checkEvents(world);
}

void checkNumbers(std::string_view key, const Range& range, bool whole, const Numbers& numbers,
                  const Complain& complain) {
    for (int i = 0; i < numbers.count; ++i) {
        const double value = numbers.values[static_cast<std::size_t>(i)];
        if (range.contains(value)) continue;
        const std::string name = numbers.count == 1 ? std::string(key) : component(key, i);
        complain(key, name + " must be " + (whole ? toString(wholeRange(range)) : toString(range)) +
                          ", not " +
                          (whole ? std::to_string(static_cast<std::int64_t>(value))
                                 : formatNumber(value)));
    }
    if (numbers.count == 2 && !(numbers.values[0] < numbers.values[1]))
        complain(key, std::string(key) + ": number 2 must be greater than number 1, " +
                          formatNumber(numbers.values[0]) + ", not " +
                          formatNumber(numbers.values[1]));
}

void checkPlace(const RegionDescription& region, const IVec3& cells, const Complain& complain) {
    const std::string because = ", because the body has " + triple(cells) + " cells";
    for (int axis = 0; axis < 3; ++axis) {
        const int from = region.from[axis], to = region.to[axis], last = cells[axis] - 1;
        if (from > last)
            complain("from", component("from", axis) + " must be at most " + std::to_string(last) +
                                 ", not " + std::to_string(from) + because);
        if (to < from || to > last)
            complain("to", component("to", axis) + " must be from " + std::to_string(from) +
                               " (that of from) to " + std::to_string(last) + ", not " +
                               std::to_string(to) + because);
    }
}

void checkMotion(const ObjectDescription& object,
                 const std::function<bool(std::string_view)>& given, const Complain& complain) {
    const auto missing = [&](const std::string& more) {
        complain("position", "position is missing; give [x, y, z] in m, of its centre" + more);
    };
    if (object.fixed) {
        for (const char* key : {"mass", "velocity", "spin", "hung_from", "drag"})
            if (given(key))
                complain(key, "a fixed object has no " + std::string(key) +
                                  "; leave it out, or leave fixed out");
        if (!object.position) missing("");
    }
    if (object.kinematic)
        for (const char* key : {"fixed", "hung_from"})
            if (given(key))
                complain(key, "a kinematic object is moved by whoever puts it somewhere; leave " +
                                  std::string(key) + " out, or leave kinematic out");
    if (object.hungFrom) {
        if (!object.position) missing(", where it hangs at first");
        if (!((*object.hungFrom - *object.position).norm() >= 1e-3))
            complain("hung_from", "hung_from must be at least 0.001 m from position");
    }
    if (object.position) return;
    for (const char* key : {"velocity", "spin"})
        if (given(key))
            complain(key,
                     "an object without position is not there until an event throws it; give "
                     "position, or " +
                         std::string(key) + " in the event");
}

void checkEvent(const EventDescription& event, std::size_t bodies, const Complain& complain) {
    constexpr std::size_t kKinds = 3;  // the fourth name is that of a throw
    checkChoice("kind", event.kind, kEventNames, complain, kKinds);
    checkNumbers(eventRules(event.kind), event, complain);
    checkNumbers(blastRules(), event, complain);
    checkIndex("body", event.body, bodies, "bodies", complain, true);
    const bool blast = event.body == kEveryBody;
    if (blast && event.kind != EventDescription::Kind::Velocity)
        complain("kind",
                 "an event of every body must be of the kind velocity; what mass its ball will "
                 "hold is not known");
    if (!blast && (event.outward != 0 || event.falloff))
        complain(event.falloff ? "falloff" : "outward",
                 std::string("only an event of every body has ") +
                     (event.falloff ? "falloff" : "outward") + "; leave it out, or give no body");
}

void checkThrow(const ThrowDescription& thrown, const std::vector<ObjectDescription>& objects,
                const Complain& complain) {
    checkNumbers(throwRules(), thrown, complain);
    checkIndex("object", thrown.object, objects.size(), "objects", complain);
    checkThrown(objects[thrown.object], complain);
}

void checkThrown(const ObjectDescription& object, const Complain& complain) {
    const std::string name = object.name.empty() ? "the object" : inQuotes(object.name);
    if (object.unyielding())
        complain("object", name + " is " + (object.fixed ? "fixed" : "kinematic") +
                               "; only others can be thrown");
    if (object.hungFrom)
        complain("object", name + " hangs from a chain; give it a velocity instead of throwing it");
}

std::int64_t cellsOf(const IVec3& cells, std::int64_t copies) {
    // One product at a time: three factors of 2²⁴ do not fit into 64 bits.
    std::int64_t count = std::int64_t{cells[0]} * cells[1];
    for (const std::int64_t factor : {std::int64_t{cells[2]}, copies})
        if (count <= kMaxCells) count *= factor;
    return count;
}

std::string nameTaken(std::string_view kind, std::string_view name) {
    const std::string what(kind);
    return "there is already " + std::string(what == "object" ? "an " : "a ") + what + " named " +
           inQuotes(name) + "; every " + what + " needs a name of its own";
}

std::string namedTwice(std::string_view key, std::string_view name) {
    return std::string(key) + " names " + inQuotes(name) + " twice; once is enough";
}

}  // namespace sunder::core
