#include "scene/event_reader.hpp"

#include "core/names.hpp"
#include "core/wording.hpp"
#include "scene/limits.hpp"
#include "scene/object_reader.hpp"

namespace sunder::scene {

using namespace core;

namespace {

constexpr std::size_t kBlast = 3, kThrow = 4;
constexpr std::string_view kPushKeys[] = {"point", "radius", "vector", "duration"};
constexpr std::string_view kBodyKeys[] = {"body"};
constexpr std::string_view kBlastKeys[] = {"outward", "falloff"};
constexpr std::string_view kThrowKeys[] = {"object", "from", "velocity", "spin"};

/// Keys that belong to another kind of event.
void refuse(const TableReader& reader, std::span<const std::string_view> keys, std::size_t kind) {
    for (const std::string_view key : keys)
        if (reader.has(key))
            reader.fail(key, "an event of kind " + inQuotes(kEventNames[kind]) + " has no " +
                                 inQuotes(key) + "; leave it out, or change kind");
}

/// What a ball holds of every body, wherever it is by then.
void readBlast(const TableReader& reader, EventDescription& event) {
    event.kind = EventDescription::Kind::Velocity;
    event.body = kEveryBody;
    event.falloff = true;
    reader.require("time", "when it starts, in s");
    reader.require("point", "[x, y, z] in m, in the world");
    reader.require("radius", "how far it reaches, in m");
    if (!reader.has("vector"))
        reader.require("outward", "the speed away from point that it gives, in m/s");
    reader.read(eventRules(event.kind), event);
    reader.read(blastRules(), event);
    reader.read("falloff", event.falloff);
}

}  // namespace

void readEvents(const TableReader& scene, const BodyReader& bodies, WorldDescription& world) {
    TableReader::Keys keys{"time", "kind"};
    for (const std::span<const std::string_view> more :
         {std::span<const std::string_view>(kPushKeys), {kBodyKeys}, {kBlastKeys}, {kThrowKeys}})
        keys.insert(keys.end(), more.begin(), more.end());
    for (const TableReader& reader : scene.tables("event", keys, kMaxEvents)) {
        EventDescription event;
        event.where = reader.where();
        reader.require("kind", "one of " + joined(kEventNames));
        const std::size_t kind = *reader.readChoice("kind", kEventNames);
        if (kind == kThrow) refuse(reader, kPushKeys, kind);
        if (kind == kThrow || kind == kBlast) refuse(reader, kBodyKeys, kind);
        if (kind != kBlast) refuse(reader, kBlastKeys, kind);
        if (kind != kThrow) refuse(reader, kThrowKeys, kind);
        if (kind == kThrow) {
            readThrow(reader, world);
            continue;
        }
        if (kind == kBlast) {
            readBlast(reader, event);
            world.events.push_back(event);
            continue;
        }
        event.kind = static_cast<EventDescription::Kind>(kind);
        const auto rules = eventRules(event.kind);
        reader.require("time", "when it starts, in s");
        reader.require("point", "[x, y, z] in m from the centre of the body's bottom face");
        reader.require("radius", "the size of the patch it acts on, in m");
        reader.require("vector",
                       "[x, y, z] in " + std::string(findRule(rules, "vector")->range.unit));
        if (event.kind == EventDescription::Kind::Force)
            reader.require("duration", "how long the force acts, in s");
        reader.read(rules, event);

        reader.require("body", "the name of the body it acts on");
        std::string body;
        reader.read("body", body, kMaxName);
        const std::vector<int> targets = bodies.find(body);
        if (targets.empty())
            reader.fail("body", "there is no body " + inQuotes(body) +
                                    "; bodies: " + printable(joined(bodies.names()), 500) +
                                    suggestion(body, bodies.names()));
        if (world.events.size() + targets.size() > kMaxEvents)
            reader.fail("body", "the scene has too many events with this one on " +
                                    std::to_string(targets.size()) + " bodies; at most " +
                                    std::to_string(kMaxEvents) + " are allowed");
        for (const int target : targets) {
            event.body = target;
            world.events.push_back(event);
        }
    }
}

}  // namespace sunder::scene
