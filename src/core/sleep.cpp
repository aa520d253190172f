#include "core/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder {

double calmSpeed(const Body& body) {
    return kSleepSpeed * body.cellSize.minCoeff();
}

double creepSpeed(const Body& body) {
    return kCreepSpeed * body.cellSize.minCoeff();
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

}  // namespace sunder
