// What a world must be beside its numbers being in range: each mistake becomes one sentence.
#include "core/check.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "catch.hpp"
#include "core/event.hpp"
#include "core/limits.hpp"
#include "core/world.hpp"
#include "support/object_worlds.hpp"
#include "support/peak_memory.hpp"
#include "support/scene_text.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A body of 3 × 2 × 2 cells, a ball and a throw of it.
WorldDescription described() {
    WorldDescription d = block({3, 2, 2}, softElastic());
    d.bodies[0].name = "wall";
    d.contact = true;
    d.objects = {ball(0.1, 1, {0, 1, 3}, {0, 0, 0})};
    d.objects[0].name = "ball";
    d.throws = {{0.1, 0, {0, 1, 3}, {0, 0, -5}, {0, 0, 0}}};
    d.events = {hit(0, {0, 0.1, 0}, {0, 0, -1})};
    return d;
}

/// What a world is refused with, by the check alone and by World.
std::string refusal(const WorldDescription& d) {
    const std::string said = messageOf([&] { check(d); });
    CHECK(messageOf([&] { const World world(d); }) == said);
    return said;
}

using Mistake = std::function<void(WorldDescription&)>;

constexpr int kLeast = std::numeric_limits<int>::min(), kMost = std::numeric_limits<int>::max();

}  // namespace

TEST_CASE("a mistake in a world becomes one sentence") {
    REQUIRE(refusal(described()) == "");
    const std::vector<std::pair<Mistake, std::string>> cases{
        {[](auto& d) { d = {}; }, "the world has no bodies; add at least one"},
        {[](auto& d) { d.bodies.clear(); }, "the world has no bodies; add at least one"},
        {[](auto& d) { d.materials.clear(); }, "the world has no materials; add at least one"},
        // Names.
        {[](auto& d) { d.bodies.push_back(d.bodies[0]); },
         "body 'wall': there is already a body named 'wall'; every body needs a name of its own"},
        {[](auto& d) { d.objects.push_back(d.objects[0]); },
         "object 'ball': there is already an object named 'ball'; every object needs a name of "
         "its own"},
        {[](auto& d) { d.bodies[0].name = "a\nb"; },
         "body 'a\\nb': name must be one line without control characters, not the text 'a\\nb'"},
        {[](auto& d) { d.bodies[0].name = "a\xff"; },
         "body 'a\\xff': name must be valid UTF-8, not the text 'a\\xff'"},
        {[](auto& d) { d.bodies[0].name = std::string(65, 'x'); },
         "name must be at most 64 characters long"},
        {[](auto& d) { d.objects[0].name = std::string(65, 'x'); },
         "name must be at most 64 characters long"},
        {[](auto& d) { d.materials[0].name = "a\x1b"; },
         "material 'a\\u001b': name must be one line without control characters"},
        {[](auto& d) { d.materials[0].description = std::string(1001, 'x'); },
         "material 'soft': description must be at most 1000 characters long"},
        // Enumerations.
        {[](auto& d) { d.materials[0].law = static_cast<ConstitutiveLaw>(2); },
         "material 'soft': law must be one of green, corotated, not number 2"},
        {[](auto& d) { d.materials[0].fracture = static_cast<FractureMode>(-1); },
         "fracture must be one of none, cell, bond, not number -1"},
        {[](auto& d) { d.materials[0].clusters = static_cast<ClusterKind>(kMost); },
         "clusters must be one of none, voronoi, running-bond, planks, not number 2147483647"},
        {[](auto& d) { d.materials[0].surface = static_cast<SurfaceKind>(6); },
         "surface must be one of plain, wood, brick, concrete, rubber, glass, not number 6"},
        {[](auto& d) { d.bodies[0].anchors = {static_cast<Side>(6)}; },
         "body 'wall': anchor must be one of left, right, bottom, top, back, front, not number 6"},
        {[](auto& d) { d.objects[0].shape = static_cast<ObjectShape>(3); },
         "object 'ball': shape must be one of sphere, box, capsule, not number 3"},
        {[](auto& d) { d.events[0].kind = static_cast<EventDescription::Kind>(3); },
         "event 1: kind must be one of impulse, force, velocity, not number 3"},
        {[](auto& d) {
             d.bodies[0].anchors = {Side::Top, Side::Left, Side::Top};
         },
         "body 'wall': anchor names 'top' twice; once is enough"},
        // Indices.
        {[](auto& d) { d.bodies[0].material = 1; },
         "body 'wall': material must be the index of one of the 1 materials, counted from 0, not "
         "1"},
        {[](auto& d) { d.bodies[0].material = kLeast; }, "not -2147483648"},
        {[](auto& d) {
             d.bodies[0].regions = {{{0, 0, 0}, {0, 0, 0}, 1}};
         },
         "region 1 of body 'wall': material must be -1 or the index of one of the 1 materials, "
         "counted from 0, not 1"},
        {[](auto& d) {
             d.bodies[0].regions = {{{0, 0, 0}, {0, 0, 0}, -2}};
         },
         "not -2"},
        {[](auto& d) { d.events[0].body = -2; },
         "event 1: body must be -1 or the index of one of the 1 bodies, counted from 0, not -2"},
        {[](auto& d) { d.events[0].body = kMost; }, "not 2147483647"},
        {[](auto& d) { d.throws[0].object = 1; },
         "throw 1: object must be the index of one of the 1 objects, counted from 0, not 1"},
        {[](auto& d) { d.objects.clear(); }, "throw 1: object must be the index of one of the 0"},
        // Events of every body.
        {[](auto& d) {
             d.events[0].body = kEveryBody;
             d.events[0].kind = EventDescription::Kind::Force;
         },
         "event 1: an event of every body must be of the kind velocity"},
        {[](auto& d) { d.events[0].falloff = true; },
         "event 1: only an event of every body has falloff; leave it out, or give no body"},
        {[](auto& d) { d.events[0].outward = 1; }, "event 1: only an event of every body has"},
        {[](auto& d) {
             d.events[0].body = kEveryBody;
             d.events[0].outward = std::nan("");
         },
         "event 1: outward must be from -1e12 to 1e12 m/s, not nan"},
        // Regions.
        {[](auto& d) {
             d.bodies[0].regions = {{{0, 0, 0}, {0, 0, 0}, 0}, {{0, 2, 0}, {0, 2, 0}}};
         },
         "region 2 of body 'wall': from: number 2 must be at most 1, not 2, because the body has "
         "[3, 2, 2] cells"},
        {[](auto& d) {
             d.bodies[0].regions = {{{1, 0, 0}, {0, 0, 0}, 0}};
         },
         "to: number 1 must be from 1 (that of from) to 2, not 0, because the body has"},
        {[](auto& d) {
             d.bodies[0].regions = {{{0, 0, 0}, {0, 0, kMost}, 0}};
         },
         "to: number 3 must be a whole number from 0 to 16777216, not 2147483647"},
        {[](auto& d) {
             d.bodies[0].regions = {{{0, 0, kLeast}, {0, 0, 0}, 0}};
         },
         "from: number 3 must be a whole number from 0 to 16777216, not -2147483648"},
        // How many.
        {[](auto& d) {
             d.bodies[0].cells = {4096, 4096, 2};
         },
         "the world is too large: it has more than 16777216 cells with body 'wall'"},
        {[](auto& d) { d.bodies[0].cells.setConstant(1 << 24); }, "the world is too large"},
        {[](auto& d) {
             d.bodies[0].cells = {kMost, kMost, kMost};
         },
         "body 'wall': cells: number 1 must be a whole number from 1 to 16777216, not 2147483647"},
        {[](auto& d) {
             d.bodies[0].cells = {1 << 12, 1 << 11, 1};
             d.bodies[0].name.clear();
             d.bodies.resize(3, d.bodies[0]);
         },
         "the world is too large: it has more than 16777216 cells with body 3"},
        {[](auto& d) { d.bodies.resize(kMaxBodies + 1); },
         "the world has more than 10000 bodies; use fewer"},
        {[](auto& d) {
             d.bodies[0].regions.resize(kMaxRegions + 1, {{}, {}, 0});
         },
         "the world has more than 256 regions of body 'wall'; use fewer"},
        {[](auto& d) { d.events.resize(kMaxEvents + 1); },
         "the world has more than 10000 events; use fewer"},
        {[](auto& d) { d.throws.resize(kMaxEvents + 1); },
         "the world has more than 10000 throws; use fewer"},
        {[](auto& d) { d.objects.resize(kMaxObjects + 1); },
         "the world has more than 250 objects; use fewer"},
        {[](auto& d) { d.bodies[0].orientation.coeffs() *= 2; },
         "body 'wall': orientation must be a quaternion of length 1, not 2"},
        {[](auto& d) { d.bodies[0].orientation.coeffs().setZero(); }, "of length 1, not 0"},
        {[](auto& d) { d.bodies[0].orientation.y() = std::nan(""); }, "of length 1, not nan"},
        {[](auto& d) { d.bodies[0].orientation.w() = HUGE_VAL; }, "of length 1, not inf"},
        // Objects.
        {[](auto& d) { d.contact = false; },
         "the world has objects, but cells do not touch: enable contact"},
        {[](auto& d) { d.objects[0].halfSize[1] = 0.2; },
         "object 'ball': radius must be the same along x, y and z, not 0.1, 0.2 and 0.1 m"},
        {[](auto& d) {
             d.objects[0].shape = ObjectShape::Capsule;
             d.objects[0].halfSize = {0.1, 0.3, 0.2};
         },
         "object 'ball': radius must be the same along x and z, not 0.1 and 0.2 m"},
        {[](auto& d) {
             d.objects[0].shape = ObjectShape::Capsule;
             d.objects[0].halfSize = {0.3, 0.2, 0.3};
         },
         "object 'ball': length must be from 0.6 to 2000 m, not 0.4"},
        {[](auto& d) { d.objects[0].halfSize[2] = std::nan(""); }, "radius must be the same"},
        {[](auto& d) { d.objects[0].orientation.coeffs() *= 2; },
         "object 'ball': orientation must be a quaternion of length 1, not 2"},
        {[](auto& d) { d.objects[0].orientation.coeffs().setZero(); }, "of length 1, not 0"},
        {[](auto& d) { d.objects[0].orientation.x() = std::nan(""); }, "of length 1, not nan"},
        {[](auto& d) {
             d.throws.clear();
             d.objects[0].fixed = true;
             d.objects[0].spin = {0, 1, 0};
         },
         "object 'ball': a fixed object has no spin; leave it out, or leave fixed out"},
        {[](auto& d) {
             d.objects[0].fixed = true;
             d.objects[0].position.reset();
         },
         "object 'ball': position is missing; give [x, y, z] in m, of its centre"},
        {[](auto& d) {
             d.objects[0].hungFrom = Vec3(0, 2, 0);
             d.objects[0].position.reset();
         },
         "of its centre, where it hangs at first"},
        {[](auto& d) { d.objects[0].hungFrom = d.objects[0].position; },
         "object 'ball': hung_from must be at least 0.001 m from position"},
        {[](auto& d) {
             d.objects[0].position.reset();
             d.objects[0].velocity = {0, 0, 1};
         },
         "object 'ball': an object without position is not there until an event throws it; give "
         "position, or velocity in the event"},
        {[](auto& d) { d.objects[0].fixed = true; },
         "throw 1: 'ball' is fixed; only others can be thrown"},
        {[](auto& d) { d.objects[0].hungFrom = Vec3(0, 2, 0); },
         "throw 1: 'ball' hangs from a chain; give it a velocity instead of throwing it"},
        // Rooms.
        {[](auto& d) {
             d.room = RoomDescription{{1, 1}, {-1, 1}, 0.5, {}};
         },
         "room: x: number 2 must be greater than number 1, 1, not 1"},
    };
    for (const auto& [mistake, part] : cases) {
        WorldDescription d = described();
        mistake(d);
        checkParts(refusal(d), {part});
    }
}

TEST_CASE("an event that is given while time runs is checked as one of the world is") {
    const World world(described());
    EventDescription event = hit(0, {0, 0.1, 0}, {0, 0, -1});
    const auto refusal = [&] { return messageOf([&] { world.makeEvent(event); }); };
    CHECK(refusal() == "");
    // Its time counts from then, and a game may run for years.
    event.time = 2 * world.step();
    CHECK(world.makeEvent(event, 1e9).start == Approx(1e9 / world.step() + 2).margin(1e-3));
    event.body = 1;
    CHECK(refusal() ==
          "the event: body must be -1 or the index of one of the 1 bodies, counted from 0, not 1");
    event.body = kEveryBody;
    CHECK(refusal() == "");
    for (const double time : {-1.0, 1e6, std::nan("")}) {
        event.time = time;
        CHECK(refusal().starts_with("the event: time must be from 0 to 100000 s, not "));
    }
    event.time = 0;
    event.radius = 0;
    CHECK(refusal().starts_with("the event: radius must be greater than 0"));
    event.radius = 1;
    event.vector[1] = std::nan("");
    event.where = "push";
    CHECK(refusal().starts_with("push: vector: number 2 must be from -1e12 to 1e12 m/s, not nan"));
    event = hit(0, {9, 0, 0}, {0, 0, -1});
    CHECK(refusal().starts_with("the event: no free node of body 'wall' lies within radius"));
}

TEST_CASE("names may be left out, and as long as they may be") {
    WorldDescription d = described();
    d.bodies[0].name = std::string(kMaxName, 'x');
    d.objects[0].name = d.materials[0].name = {};
    d.bodies.push_back(d.bodies[0]);
    d.bodies[1].name.clear();
    d.bodies[1].position = {2, 0, 0};
    CHECK(refusal(d) == "");
    d.bodies[1].size[0] = 0;
    CHECK(refusal(d).starts_with("body 2: size: number 1 must be "));
    d.bodies[1] = d.bodies[0];
    d.bodies[1].name.clear();
    checkParts(messageOf([&] { const World world(d); }), {"body 2 and body 'xxx", "overlap by"});
    d.bodies.pop_back();
    d.events[0].point = {9, 0, 0};
    d.events[0].where.clear();
    checkParts(messageOf([&] { const World world(d); }), {"event 1: no free node of body 'xxx"});
}

TEST_CASE("more materials on cells of more sizes than a solver has room for are refused") {
    WorldDescription d = block({1, 1, 1}, softElastic());
    d.bodies[0].regions = {{{0, 0, 0}, {0, 0, 0}, 1}};
    d.materials.push_back(d.materials[0]);
    while (d.bodies.size() < 128) {
        d.bodies.push_back(d.bodies[0]);
        d.bodies.back().size[1] = 1 + 0.01 * static_cast<double>(d.bodies.size());
    }
    CHECK(refusal(d) == "");
    CHECK(World(d).laws().size() == 256);
    d.bodies.push_back(d.bodies[0]);
    CHECK(refusal(d) == "");
    d.bodies.back().size[1] = 5;
    CHECK(refusal(d) ==
          "the world has more than 256 combinations of material and cell size; use fewer");
}

TEST_CASE("a world that is refused takes no memory for its cells") {
    WorldDescription d = block({4096, 4096, 1}, softElastic());  // 100 MB for the first two arrays
    d.bodies[0].size = {1000, 1000, 1};
    d.gravity[1] = std::nan("");
    WorldDescription many = d;
    many.gravity.setZero();
    many.events = {hit(1, {0, 0, 0}, {0, 0, 1})};
    for (const WorldDescription& bad : {d, many}) {
        const std::int64_t taken =
            peakMemory([&] { CHECK_FALSE(messageOf([&] { const World world(bad); }).empty()); });
        INFO(taken << " bytes");
        CHECK(taken < 10'000'000);
    }
}
