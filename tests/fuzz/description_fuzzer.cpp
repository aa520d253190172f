// Worlds described in code, by arbitrary numbers: refused in a sentence, or laid out and simulated
// for a few steps.
//
// The input is a list of changes to a world of one body: which struct, which of its rules or other
// members, which number, and what becomes of it: any double, a small number, or an end of the
// rule's range.
#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "core/check.hpp"
#include "core/diagnostics.hpp"
#include "core/event.hpp"
#include "core/limits.hpp"
#include "core/world.hpp"
#include "cpu/cpu_solver.hpp"
#include "fuzz/fuzzer.hpp"
#include "scene/scene.hpp"
#include "scene/scene_writer.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

// So that an input takes milliseconds.
constexpr std::int64_t kFewCells = 64;
constexpr std::size_t kFewThings = 8;

using Bytes = fuzz::Input;

double numberFor(const Range& range, bool whole, Bytes& bytes) {
    double value = 0;
    switch (bytes.below(8)) {
        case 0:
            value = bytes.take<double>();  // anything, NaN and infinity among it
            break;
        case 1:
            value = range.least();
            break;
        case 2:
            value = range.most();
            break;
        case 3:
            value = bytes.take<std::int32_t>();
            break;
        case 4:  // a decimal near 0, where most things happen
            value = 0.01 * bytes.take<std::int16_t>();
            break;
        default:  // small wholes, which most counts want
            value = static_cast<double>(bytes.take<std::int8_t>());
            break;
    }
    // A rule's setter makes an int of it, which what is in an int already is.
    if (whole &&
        !(value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max()))
        value = -1;
    return value;
}

template <class Struct>
void change(std::span<const Rule<Struct>> rules, Struct& object, Bytes& bytes) {
    if (rules.empty()) return;
    const Rule<Struct>& rule = rules[bytes.below(rules.size())];
    Numbers numbers = rule.get(object);
    const int count = rule.count();
    // All alike, or one of them.
    const std::size_t which = bytes.below(static_cast<std::size_t>(count) + 1);
    const double value = numberFor(rule.range, rule.whole(), bytes);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        if (which == static_cast<std::size_t>(count) || which == i) numbers.values[i] = value;
    numbers.count = count;
    rule.set(object, numbers);
}

/// An enumeration, which need not have such a value.
template <class Enum>
Enum choice(Bytes& bytes) {
    return static_cast<Enum>(bytes.take<std::int8_t>());
}

int index(Bytes& bytes) {
    return bytes.below(8) == 0 ? bytes.take<int>() : bytes.take<std::int8_t>();
}

std::string text(Bytes& bytes) {
    std::string name(bytes.take<std::uint8_t>() % (kMaxName + 2), 'x');
    if (!name.empty()) name[0] = bytes.take<char>();
    return name;
}

/// One of a list, which may grow by one.
template <class Thing>
Thing& someOf(std::vector<Thing>& things, Bytes& bytes) {
    const std::size_t at = bytes.below(kFewThings);
    if (at >= things.size()) things.emplace_back();
    return things[std::min(at, things.size() - 1)];
}

void changeMaterial(Material& material, Bytes& bytes) {
    switch (bytes.below(8)) {
        case 0:
            material.law = choice<ConstitutiveLaw>(bytes);
            break;
        case 1:
            material.fracture = choice<FractureMode>(bytes);
            break;
        case 2:
            material.clusters = choice<ClusterKind>(bytes);
            break;
        case 3:
            material.surface = choice<SurfaceKind>(bytes);
            break;
        case 4:
            material.name = text(bytes);
            break;
        default:
            change(materialRules(), material, bytes);
    }
}

void changeBody(BodyDescription& body, Bytes& bytes) {
    switch (bytes.below(8)) {
        case 0:
            body.material = index(bytes);
            break;
        case 1:
            body.anchors.push_back(choice<Side>(bytes));
            break;
        case 2:
            change(regionRules(), someOf(body.regions, bytes), bytes);
            break;
        case 3:
            someOf(body.regions, bytes).material = index(bytes);
            break;
        case 4:
            body.mayOverlap = bytes.below(2) == 1;
            break;
        case 5:
            body.name = text(bytes);
            break;
        case 6:
            // By a number that may be any; half the time it is of length 1 all the same.
            body.orientation.coeffs()[static_cast<int>(bytes.below(4))] = bytes.take<double>();
            if (bytes.below(2) == 1) body.orientation.normalize();
            break;
        default:
            change(bodyRules(), body, bytes);
    }
}

void changeEvent(EventDescription& event, Bytes& bytes) {
    switch (bytes.below(8)) {
        case 0:
            event.body = index(bytes);
            break;
        case 2:
            event.falloff = bytes.below(2) == 1;
            break;
        case 3:
            change(blastRules(), event, bytes);
            break;
        case 1:
            event.kind = choice<EventDescription::Kind>(bytes);
            break;
        default:
            change(eventRules(event.kind), event, bytes);
    }
}

void changeObject(ObjectDescription& object, Bytes& bytes) {
    switch (bytes.below(10)) {
        case 0:
            object.shape = choice<ObjectShape>(bytes);
            break;
        case 1:
            object.fixed = bytes.below(2) == 1;
            break;
        case 2:
            object.mayOverlap = bytes.below(2) == 1;
            break;
        case 3:
            if (bytes.below(2) == 1)
                object.position.reset();
            else
                object.hungFrom.reset();
            break;
        case 4:
            object.orientation.coeffs()[static_cast<int>(bytes.below(4))] = bytes.take<double>();
            break;
        case 5:
            object.halfSize[static_cast<int>(bytes.below(3))] = bytes.take<double>();
            break;
        case 6:
            change(shapeRules(object.shape), object, bytes);
            break;
        case 7: {
            const Rule<ObjectDescription> length = lengthRule(object.halfSize[0]);
            change(std::span(&length, 1), object, bytes);
            break;
        }
        default:
            change(objectRules(), object, bytes);
    }
}

void changeWorld(WorldDescription& world, Bytes& bytes) {
    switch (bytes.below(8)) {
        case 0:
            world.ground = bytes.below(2) == 1;
            break;
        case 1:
            world.contact = bytes.below(2) == 1;
            break;
        case 2:
            world.seed = bytes.take<std::uint64_t>();
            break;
        case 3:
            change(solverRules(), world, bytes);
            break;
        case 4:
            change(groundRules(), world, bytes);
            break;
        case 5:
            change(contactRules(), world, bytes);
            break;
        case 6:
            if (!world.room) world.room.emplace();
            change(roomRules(), *world.room, bytes);
            break;
        default:
            change(worldRules(), world, bytes);
    }
}

WorldDescription described(Bytes bytes) {
    WorldDescription world;
    world.materials.emplace_back();
    world.bodies.emplace_back().cells = {2, 2, 1};
    world.contact = true;
    while (bytes.any()) {
        switch (bytes.below(8)) {
            case 0:
                changeMaterial(someOf(world.materials, bytes), bytes);
                break;
            case 1:
                changeEvent(someOf(world.events, bytes), bytes);
                break;
            case 2:
                changeObject(someOf(world.objects, bytes), bytes);
                break;
            case 3: {
                ThrowDescription& thrown = someOf(world.throws, bytes);
                if (bytes.below(4) == 0)
                    thrown.object = index(bytes);
                else
                    change(throwRules(), thrown, bytes);
                break;
            }
            case 4:
                changeWorld(world, bytes);
                break;
            case 5:  // copies of what there is
                if (world.bodies.size() < kFewThings) world.bodies.push_back(world.bodies.back());
                break;
            default:
                changeBody(someOf(world.bodies, bytes), bytes);
        }
    }
    return world;
}

bool small(const WorldDescription& world) {
    std::int64_t cells = 0;
    for (const BodyDescription& body : world.bodies) cells += cellsOf(body.cells);
    return cells <= kFewCells;
}

void simulate(const WorldDescription& description) {
    const World world(description);
    cpu::CpuSolver solver(world, 1);
    solver.advance(40);  // a search for contacts is among them
    diagnose(world, solver.state());
}

/// What a world may be, a file may say, too, but for blasts and half of the seeds.
void writeAndRead(const WorldDescription& world) {
    if (world.seed > std::uint64_t{std::numeric_limits<std::int64_t>::max()} ||
        std::any_of(world.events.begin(), world.events.end(),
                    [](const EventDescription& event) { return event.body == kEveryBody; }))
        return;
    scene::Scene scene;
    scene.title = "written";
    scene.world = world;
    const scene::Scene again = scene::parseScene(scene::writeScene(scene), "written.toml", {});
    if (again.world.bodies.size() != world.bodies.size()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const WorldDescription world = described(Bytes(data, size));
    try {
        check(world);
    } catch (const InputError& error) {
        fuzz::checkSentence(error);
        return 0;
    }
    writeAndRead(world);
    if (!small(world)) return 0;
    try {
        simulate(world);
    } catch (const InputError& error) {
        fuzz::checkSentence(error);
    }
    return 0;
}
