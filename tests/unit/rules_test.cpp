// Every number of a description, at the ends of its range and beyond, in code and in a file.
#include "core/rules.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "catch.hpp"
#include "core/check.hpp"
#include "core/wording.hpp"
#include "scene/scene.hpp"
#include "scene/scene_rules.hpp"
#include "scene/scene_writer.hpp"
#include "support/scene_text.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One of everything.
scene::Scene everything() {
    scene::Scene scene;
    scene.title = "Everything";
    WorldDescription& world = scene.world;
    world.materials.emplace_back().name = "stuff";
    BodyDescription& body = world.bodies.emplace_back();
    body.name = "wall";
    body.regions.emplace_back().material = 0;
    world.events.emplace_back();
    ObjectDescription& ball = world.objects.emplace_back();
    ball.name = "ball";
    ball.position = Vec3(0.5, 0.6, 0.7);
    ball.hungFrom = Vec3(0.8, 2, 0.9);
    ObjectDescription& crate = world.objects.emplace_back();
    crate.name = "crate";
    crate.shape = ObjectShape::Box;
    ObjectDescription& log = world.objects.emplace_back();
    log.name = "log";
    log.shape = ObjectShape::Capsule;
    log.halfSize = {0.1, 0.5, 0.1};
    world.throws.emplace_back().object = 1;
    world.room.emplace().ceiling = 3;
    world.contact = true;
    return scene;
}

template <class Struct>
using Pick = Struct& (*)(WorldDescription&);

/// What is wrong with the world, in code; empty: nothing.
std::string inCode(const scene::Scene& scene) {
    return messageOf([&] { check(scene.world); });
}

/// The same in a file that says the same.
std::string inFile(const scene::Scene& scene) {
    return messageOf([&] { scene::parseScene(scene::writeScene(scene), "walls.toml", {}); });
}

/// Numbers that a rule refuses.
std::vector<double> refused(const Range& range, bool whole) {
    if (whole) {
        std::vector<double> all{range.min - 1, range.max + 1};
        for (const int end : {std::numeric_limits<int>::min(), std::numeric_limits<int>::max()})
            all.push_back(end);
        return all;
    }
    return {range.minExcluded ? range.min : std::nextafter(range.min, -kInfinity),
            range.maxExcluded ? range.max : std::nextafter(range.max, kInfinity),
            -1e300,
            1e300,
            -kInfinity,
            kInfinity,
            std::nan(""),
            -std::nan("")};
}

template <class Struct>
void tryRule(const Rule<Struct>& rule, const std::string& thing, Pick<Struct> pick,
             bool alsoInFile) {
    const scene::Scene good = everything();
    const int count = rule.count();
    for (int i = 0; i < count; ++i) {
        INFO(thing << ": " << rule.key << ", number " << i + 1);
        const auto with = [&](double value) {
            scene::Scene scene = good;
            Struct& object = pick(scene.world);
            Numbers numbers = rule.get(object);
            REQUIRE(numbers.count == count);
            numbers.values[i] = value;
            rule.set(object, numbers);
            return scene;
        };
        for (const double value : refused(rule.range, rule.whole())) {
            const scene::Scene bad = with(value);
            const std::string shown = rule.whole()
                                          ? std::to_string(static_cast<std::int64_t>(value))
                                          : formatNumber(value);
            const std::string sentence =
                (count == 1 ? std::string(rule.key) : component(rule.key, i)) + " must be " +
                (rule.whole() ? toString(wholeRange(rule.range)) : toString(rule.range)) +
                ", not " + shown;
            CHECK(inCode(bad) == (thing.empty() ? "" : thing + ": ") + sentence);
            if (alsoInFile) {
                const std::string said = inFile(bad);
                INFO("file: " << said);
                CHECK(said.starts_with("walls.toml:"));
                CHECK(said.ends_with(": " + sentence));
            }
        }
        for (const double value : {rule.range.least(), rule.range.most()}) {
            INFO("accepted: " << value);
            scene::Scene fine = with(value);
            // What else it takes: a pair in order, and a region in its body.
            if (count == 2) {
                Struct& object = pick(fine.world);
                Numbers numbers = rule.get(object);
                numbers.values = {rule.range.least(), rule.range.most(), 0};
                rule.set(object, numbers);
            }
            if (std::is_same_v<Struct, RegionDescription> && value != rule.range.min) {
                CHECK(inCode(fine).find("because the body has") != std::string::npos);
                continue;
            }
            CHECK(inCode(fine) == "");
            if (alsoInFile) CHECK(inFile(fine) == "");
        }
    }
}

template <class Struct>
void tryRules(std::span<const Rule<Struct>> rules, const std::string& thing, Pick<Struct> pick) {
    for (const Rule<Struct>& rule : rules)
        tryRule(rule, thing, pick, rule.key != "step");  // a file has substeps
}

WorldDescription& itself(WorldDescription& world) {
    return world;
}

}  // namespace

TEST_CASE("Every number is refused outside its range, in code and in files alike", "[rules]") {
    REQUIRE(inCode(everything()) == "");
    REQUIRE(inFile(everything()) == "");
    tryRules<WorldDescription>(worldRules(), "", itself);
    tryRules<WorldDescription>(solverRules(), "solver", itself);
    tryRules<WorldDescription>(groundRules(), "ground", itself);
    tryRules<WorldDescription>(contactRules(), "contact", itself);
    tryRules<RoomDescription>(
        roomRules(), "room", [](WorldDescription & w) -> auto& { return *w.room; });
    tryRules<Material>(
        materialRules(), "material 'stuff'",
        [](WorldDescription & w) -> auto& { return w.materials[0]; });
    tryRules<BodyDescription>(
        bodyRules(), "body 'wall'", [](WorldDescription & w) -> auto& { return w.bodies[0]; });
    tryRules<RegionDescription>(
        regionRules(), "region 1 of body 'wall'",
        [](WorldDescription & w) -> auto& { return w.bodies[0].regions[0]; });
    tryRules<ObjectDescription>(
        objectRules(), "object 'ball'", [](WorldDescription & w) -> auto& { return w.objects[0]; });
    tryRules<ObjectDescription>(
        shapeRules(ObjectShape::Sphere), "object 'ball'",
        [](WorldDescription & w) -> auto& { return w.objects[0]; });
    tryRules<ObjectDescription>(
        shapeRules(ObjectShape::Box), "object 'crate'",
        [](WorldDescription & w) -> auto& { return w.objects[1]; });
    tryRule<ObjectDescription>(
        lengthRule(0.1), "object 'log'", [](WorldDescription & w) -> auto& { return w.objects[2]; },
        true);
    tryRules<ThrowDescription>(
        throwRules(), "throw 1", [](WorldDescription & w) -> auto& { return w.throws[0]; });
    using Kind = EventDescription::Kind;
    tryRules<EventDescription>(
        eventRules(Kind::Impulse), "event 1",
        [](WorldDescription & w) -> auto& { return w.events[0]; });
    tryRules<EventDescription>(
        eventRules(Kind::Force), "event 1", [](WorldDescription & w) -> auto& {
            w.events[0].kind = Kind::Force;
            return w.events[0];
        });
    tryRules<EventDescription>(
        eventRules(Kind::Velocity), "event 1", [](WorldDescription & w) -> auto& {
            w.events[0].kind = Kind::Velocity;
            return w.events[0];
        });
}

TEST_CASE("Every rule says what it is about", "[rules]") {
    const auto tryAll = [](const auto& rules) {
        for (const auto& rule : rules) {
            INFO(rule.key);
            CHECK(rule.help.size() > 10);
            CHECK(rule.help.size() < 200);
            CHECK(rule.help.ends_with('.'));
            CHECK_FALSE(rule.range.unit.empty());
            CHECK(rule.range.min < rule.range.max);
        }
    };
    tryAll(materialRules());
    tryAll(bodyRules());
    tryAll(regionRules());
    tryAll(eventRules(EventDescription::Kind::Force));
    tryAll(blastRules());
    tryAll(objectRules());
    tryAll(shapeRules(ObjectShape::Sphere));
    tryAll(shapeRules(ObjectShape::Box));
    tryAll(throwRules());
    tryAll(roomRules());
    tryAll(worldRules());
    tryAll(solverRules());
    tryAll(groundRules());
    tryAll(contactRules());
    tryAll(scene::cameraRules());
    tryAll(scene::copiesRules());
    CHECK(findRule(materialRules(), "density")->range.unit == "kg/m³");
    CHECK(findRule(materialRules(), "densty") == nullptr);
}

TEST_CASE("Any number of substeps that a file may have is a step that a world may have",
          "[rules]") {
    const Range& step = findRule(worldRules(), "step")->range;
    for (const double substeps : {scene::kSubstepsRule.range.min, scene::kSubstepsRule.range.max})
        CHECK(step.contains(1 / (60 * substeps)));
}
