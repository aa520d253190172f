#pragma once
#include "core/world.hpp"

namespace sunder {

/// When a solver that lets bodies sleep may do so. A body falls asleep once it has been calm for
/// kSleepDelay seconds of simulated time: no node faster than kSleepSpeed cell edges a second (a
/// thousandth of an edge per 1/60 s), no event at work, no damage growing. (Half a second at such
/// speeds bounds the mean acceleration, too, at 4·kSleepSpeed edges/s²; a body that starts to fall
/// is past the limit within milliseconds.) Its velocities become zero, and from then on it does not
/// change by a bit and costs nothing, until an event on it, a cell of another body that hits it or
/// Solver::setState() wakes it.
inline constexpr double kSleepSpeed = 0.06;  ///< cell edges/s
inline constexpr double kSleepDelay = 0.5;   ///< s

/// The limit instead of kSleepSpeed for bodies in contact (core/contact.hpp) with themselves or
/// others. Friction that grows with the speed of sliding holds nothing for good: a heap creeps, and
/// now and then a piece topples for it, for half a minute; asleep, it stands. A sleeping body is
/// woken, too, by a cell of another one that pushes it faster than this.
inline constexpr double kCreepSpeed = 0.5;  ///< cell edges/s

/// m/s: an object slower than this may lie against a sleeping body.
inline constexpr double kStirringSpeed = 0.05;

/// m/s: a calm body has no node faster than this.
double calmSpeed(const Body& body);
/// m/s: nor one that touches something than this.
double creepSpeed(const Body& body);
/// Steps that a body must be calm for.
int sleepSteps(const World& world);
/// Whether an event acts on the body at any time within steps from .. to − 1.
bool pushedWithin(const World& world, int body, std::int64_t from, std::int64_t to);
/// The first step from `from` on that an event acts on the body in; the largest number there is
/// where none does.
std::int64_t nextPush(const World& world, int body, std::int64_t from);

}  // namespace sunder
