#pragma once
#include "core/constants.hpp"
#include "core/world.hpp"

namespace sunder::core {

/// When a solver that lets bodies and objects sleep may do so.
///
/// A body is ready to once it has been calm for kSleepDelay seconds of simulated time: no node
/// faster than kSleepSpeed cell edges a second (a thousandth of an edge per 1/60 s), no event at
/// work, no damage growing. What falls freely is past the limit of calmSpeed() within a fifth of
/// that time, so nothing sleeps at the top of its flight. An object is ready once it has been calm
/// as long: no event reaches it, and it rests on something and is slower than kStirringSpeed, or
/// hangs and is slower than kHangingSpeed, or does not move at all.
///
/// Bodies and objects that touch form an island (core/rest_islands.hpp), which falls asleep only as
/// a whole, when all of it is ready. Velocities become zero, and from then on it does not change by
/// a bit and costs nothing. It wakes as a whole, too: for an event on one of them, a cell or an
/// object that hits one of them, a throw of one of its objects, Solver::setState().
inline constexpr double kSleepSpeed = 0.06;  ///< cell edges/s
inline constexpr double kSleepDelay = 0.5;   ///< s

// kCreepSpeed is the limit instead of kSleepSpeed for bodies in contact (core/contact.hpp) with
// themselves or others. Friction that grows with the speed of sliding holds nothing for good: a
// heap creeps, and now and then a piece topples for it, for half a minute; asleep, it stands. A
// sleeping body is woken, too, by a cell of another one that pushes it faster than this.

/// m/s: an object slower than this, with what its spin adds at its farthest point, may sleep where
/// it rests, and lie against what sleeps.
inline constexpr double kStirringSpeed = 0.05;
/// m/s: one on a chain that touches nothing. At the turning points of a swing it is slower than
/// this for kSleepDelay only where the swing's acceleration is below 0.02 m/s².
inline constexpr double kHangingSpeed = 0.005;

/// m/s: a calm body has no node faster than this. (At most a tenth of what it would gain by falling
/// for kSleepDelay; without gravity and anchors next to nothing, for it rests on nothing. What may
/// be on its way out of something, core/overlap.hpp, is never calm at more than a quarter of the
/// speed it is pushed with: Body::calmest.) released: whether its anchors have let go.
double calmSpeed(const World& world, const Body& body, bool released = false);
/// m/s: nor one that touches something than this.
double creepSpeed(const World& world, const Body& body, bool released = false);

/// What an object did in the steps since it was last looked at.
struct ObjectUnrest {
    double fastest = 0;    ///< m/s, with what its spin adds at its farthest point
    bool touched = false;  ///< a cell, an object, the ground or the room
    bool hung = false;     ///< its chain was taut
};
bool calm(const ObjectUnrest& unrest);

/// Steps that a body must be calm for.
int sleepSteps(const World& world);

}  // namespace sunder::core
