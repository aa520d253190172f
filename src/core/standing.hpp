#pragma once
#include <array>
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

/// Parts of a gap in edges (of bodies' cells, of objects' smallest thickness) up to which one thing
/// stands on another when the world begins: what a scene rounds, not what may fall.
inline constexpr double kStandingGap = 0.02;

/// Bodies and objects that lean on one another when the world begins, each of which something
/// carries in the end: an anchor, the ground, a wall of the room that gravity points at, or an
/// object that is fixed or hangs.
struct StandingGroup {
    std::vector<int> bodies, objects;  ///< ascending; objects are free ones that lie still
};

/// Whether an anchor holds one of a body's nodes.
bool isAnchored(const World&, int body);

struct StandingQuery {
    explicit StandingQuery(const World& world)
        : absentBodies(world.bodies().size()), absentObjects(world.objects().size()) {}
    std::vector<bool> absentBodies, absentObjects;  ///< to be looked at as if they were not there
    std::vector<std::array<int, 2>> joined;         ///< bodies that touch although they do not yet
};

/// In order of their first body. Groups without a body are left out; so is what gravity does not
/// pull, what flies at once and what nothing carries.
std::vector<StandingGroup> standingGroups(const World&, const StandingQuery&);

}  // namespace sunder::core
