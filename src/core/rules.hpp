#pragma once
#include <span>

#include "core/description.hpp"
#include "core/rule.hpp"

namespace sunder::core {

// What every number of a description may be: one table a struct. The reader of files, the check of
// a world (core/check.hpp), the viewer's sliders and the tests walk the same tables.

std::span<const Rule<Material>> materialRules();
std::span<const Rule<BodyDescription>> bodyRules();
std::span<const Rule<RegionDescription>> regionRules();
/// The kind decides the unit of `vector`.
std::span<const Rule<EventDescription>> eventRules(EventDescription::Kind);
/// What an event of every body has besides, which no file holds.
std::span<const Rule<EventDescription>> blastRules();
std::span<const Rule<ObjectDescription>> objectRules();
/// `radius` of a sphere or a capsule, `size` of a box.
std::span<const Rule<ObjectDescription>> shapeRules(ObjectShape);
/// `length` of a capsule of this radius, m.
Rule<ObjectDescription> lengthRule(double radius);
std::span<const Rule<ThrowDescription>> throwRules();
std::span<const Rule<RoomDescription>> roomRules();
/// What a scene file has at its top level, and `step`, which follows from its substeps.
std::span<const Rule<WorldDescription>> worldRules();
/// The same of its tables [solver], [ground] and [contact].
std::span<const Rule<WorldDescription>> solverRules();
std::span<const Rule<WorldDescription>> groundRules();
std::span<const Rule<WorldDescription>> contactRules();

}  // namespace sunder::core
