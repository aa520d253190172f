#pragma once
#include "core/world.hpp"
#include "scene/body_reader.hpp"
#include "scene/table_reader.hpp"

namespace sunder::scene {

/// Reads the [[event]] tables into world.events and world.throws. `bodies` must have read the
/// scene's bodies; the objects must have been read.
void readEvents(const TableReader& scene, const BodyReader& bodies, core::WorldDescription& world);

}  // namespace sunder::scene
