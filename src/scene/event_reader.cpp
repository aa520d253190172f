#include "scene/event_reader.hpp"

#include "core/names.hpp"
#include "core/wording.hpp"
#include "scene/limits.hpp"
#include "scene/object_reader.hpp"

namespace sunder::scene {

using namespace core;

namespace {

constexpr std::size_t kThrow = 3;
constexpr std::string_view kPushKeys[] = {"body", "point", "radius", "vector", "duration"};
constexpr std::string_view kThrowKeys[] = {"object", "from", "velocity", "spin"};

/// Keys that belong to another kind of event.
void refuse(const TableReader& reader, std::span<const std::string_view> keys, std::size_t kind) {
    for (const std::string_view key : keys)
        if (reader.has(key))
            reader.fail(key, "an event of kind " + inQuotes(kEventNames[kind]) + " has no " +
                                 inQuotes(key) + "; leave it out, or change kind");
}

}  // namespace

void readEvents(const TableReader& scene, const BodyReader& bodies, WorldDescription& world) {
    TableReader::Keys keys{"time", "kind"};
    keys.insert(keys.end(), std::begin(kPushKeys), std::end(kPushKeys));
    keys.insert(keys.end(), std::begin(kThrowKeys), std::end(kThrowKeys));
    for (const TableReader& reader : scene.tables("event", keys, kMaxEvents)) {
        EventDescription event;
        event.where = reader.where();
        reader.require("kind", "one of " + joined(kEventNames));
        const std::size_t kind = *reader.readChoice("kind", kEventNames);
        refuse(reader,
               kind == kThrow ? std::span<const std::string_view>(kPushKeys)
                              : std::span<const std::string_view>(kThrowKeys),
               kind);
        if (kind == kThrow) {
            readThrow(reader, world);
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
