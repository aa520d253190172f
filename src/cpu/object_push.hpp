#pragma once
#include <span>

#include "core/event.hpp"
#include "core/object_contact.hpp"

namespace sunder::cpu {

/// What blasts do to an object. Their acceleration is averaged over the box around it, along its
/// own axes, by Gauss's rule with two points on each axis: exact for polynomials of third degree.
/// Each of the eight points has an eighth of the mass, which also makes the torque about the
/// centre. A ball that holds none of them does nothing.
struct ObjectPush {
    core::Vec3 acceleration{0, 0, 0};  ///< m/s²
    core::Vec3 torque{0, 0, 0};        ///< N·m for each kilogram of the object
    bool isZero() const { return acceleration.isZero(0) && torque.isZero(0); }
};
ObjectPush objectPush(const core::RoundedBox& object, std::span<const core::Blast> blasts);

}  // namespace sunder::cpu
