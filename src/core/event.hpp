#pragma once
#include <cstdint>

#include "core/object.hpp"
#include "core/types.hpp"

namespace sunder::core {

struct Event {
    int body;
    Eigen::Vector3f
        point;  ///< m, world; single precision so that every solver picks the same nodes
    float radius;
    Vec3 acceleration;  ///< m/s²
    double start, end;  ///< in steps, fractions count
    /// Share of step number `step` that lies inside [start, end], 0 to 1.
    double weight(std::int64_t step) const;
};

/// An object that is thrown as step number `step` begins.
struct Throw {
    std::int64_t step = 0;
    int object = 0;
    ObjectState state;
};

/// Whether a node is in an event's patch. The same single-precision operations in the same order as
/// glsl/physics/events.glsl.
bool insidePatch(const Event&, const Eigen::Vector3f& rest);

}  // namespace sunder::core
