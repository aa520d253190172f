#include "core/room.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact.hpp"

namespace sunder::core {

double Barrier::depthAfter(double depth, double pushSpeed, double step) {
    const double speed = std::min(pushSpeed, depth / std::max(kPartingTime, step));
    return std::max(0.0, depth - step * speed);
}

Vec3 Barrier::stopped(const Vec3& velocity) const {
    Vec3 v = velocity;
    const double taken = friction * std::max(0.0, -side * v[axis]);
    v[axis] = 0;
    const double tangential = std::hypot(v[(axis + 2) % 3], v[(axis + 1) % 3]);
    v *= tangential > taken ? 1 - taken / tangential : 0;
    return v;
}

std::vector<Barrier> barriers(const WorldDescription& world) {
    std::vector<Barrier> result;
    if (world.ground) result.push_back({1, +1, 0, world.groundFriction});
    if (!world.room) return result;
    const RoomDescription& room = *world.room;
    for (const auto& [axis, walls] : {std::pair{0, room.x}, {2, room.z}}) {
        result.push_back({axis, +1, walls[0], room.friction});
        result.push_back({axis, -1, walls[1], room.friction});
    }
    if (room.ceiling) result.push_back({1, -1, *room.ceiling, room.friction});
    return result;
}

}  // namespace sunder::core
