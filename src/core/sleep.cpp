#include "core/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::core {

namespace {

/// m/s.
double atMost(double fastest, const World& world, const Body& body) {
    const double speed = std::min(fastest, body.calmest);
    const double falling = body.gravity.norm() * kSleepDelay;  // what it would gain
    if (falling > 0) return std::min(speed, 0.1 * falling);
    const auto& anchors = world.description().bodies[&body - world.bodies().data()].anchors;
    return anchors.empty() ? std::min(speed, 1e-3 * body.cellSize.minCoeff()) : speed;
}

}  // namespace

double calmSpeed(const World& world, const Body& body) {
    return atMost(kSleepSpeed * body.cellSize.minCoeff(), world, body);
}

double creepSpeed(const World& world, const Body& body) {
    return atMost(kCreepSpeed * body.cellSize.minCoeff(), world, body);
}

bool calm(const ObjectUnrest& unrest) {
    if (unrest.touched) return unrest.fastest <= kStirringSpeed;
    return unrest.fastest <= (unrest.hung ? kHangingSpeed : 0);
}

int sleepSteps(const World& world) {
    return static_cast<int>(std::ceil(kSleepDelay / world.step()));
}

bool pushedWithin(const World& world, int body, std::int64_t from, std::int64_t to) {
    return nextPush(world, body, from) < to;
}

std::int64_t nextPush(const World& world, int index, std::int64_t from) {
    const Body& body = world.bodies()[index];
    std::int64_t next = std::numeric_limits<std::int64_t>::max();
    for (int i = body.firstEvent; i < body.firstEvent + body.eventCount; ++i) {
        const Event& event = world.events()[i];
        if (event.end <= static_cast<double>(from)) continue;
        next = std::min(next, std::max(from, static_cast<std::int64_t>(std::floor(event.start))));
    }
    return next;
}

}  // namespace sunder::core
