#include "cpu/object_push.hpp"

#include <numbers>

namespace sunder::cpu {

using namespace core;

ObjectPush objectPush(const RoundedBox& object, std::span<const Blast> blasts) {
    const Vec3 half = (object.half + Vec3::Constant(object.radius)) * std::numbers::inv_sqrt3;
    ObjectPush push;
    for (int point = 0; point < kCorners; ++point) {
        Vec3 local;
        for (int axis = 0; axis < 3; ++axis)
            local[axis] = (point >> axis & 1 ? 1 : -1) * half[axis];
        const Vec3 arm = object.axes * local;
        const Vec3 share = accelerationAt(object.centre + arm, blasts) / kCorners;
        push.acceleration += share;
        push.torque += arm.cross(share);
    }
    return push;
}

}  // namespace sunder::cpu
