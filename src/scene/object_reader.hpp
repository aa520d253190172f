#pragma once
#include "core/world.hpp"
#include "scene/table_reader.hpp"

namespace sunder::scene {

/// Reads the [[object]] tables into world.objects. Needs world.ground to be set.
void readObjects(const TableReader& scene, core::WorldDescription& world);

/// Reads an [[event]] of kind "throw" into world.throws. The objects must have been read.
void readThrow(const TableReader& event, core::WorldDescription& world);

}  // namespace sunder::scene
