#include "core/sleep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::core {

namespace {

/// m/s.
double atMost(double fastest, const World& world, const Body& body, bool released) {
    const double speed = std::min(fastest, body.calmest);
    const double falling = body.gravity.norm() * kSleepDelay;  // what it would gain
    if (falling > 0) return std::min(speed, 0.1 * falling);
    const auto& anchors = world.description().bodies[&body - world.bodies().data()].anchors;
    return anchors.empty() || released ? std::min(speed, 1e-3 * body.cellSize.minCoeff()) : speed;
}

}  // namespace

double calmSpeed(const World& world, const Body& body, bool released) {
    return atMost(kSleepSpeed * body.cellSize.minCoeff(), world, body, released);
}

double creepSpeed(const World& world, const Body& body, bool released) {
    return atMost(kCreepSpeed * body.cellSize.minCoeff(), world, body, released);
}

bool calm(const ObjectUnrest& unrest) {
    if (unrest.touched) return unrest.fastest <= kStirringSpeed;
    return unrest.fastest <= (unrest.hung ? kHangingSpeed : 0);
}

int sleepSteps(const World& world) {
    return static_cast<int>(std::ceil(kSleepDelay / world.step()));
}

}  // namespace sunder::core
