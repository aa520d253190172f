#pragma once
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

/// A plane across an axis that nothing passes: the floor, a wall of the room or its ceiling.
///
/// What would pass one in a step is stopped: the barrier takes all of the velocity into it, Coulomb
/// friction takes at most μ times as much of the rest, and the step is done again from the barrier,
/// with what is left. One barrier after the other, in the order of barriers(): in a corner the
/// later ones see what the earlier ones left.
///
/// What begins a step beyond a barrier, by d, comes back at min(U, d/max(kPartingTime, h)), U =
/// World::pushSpeed(): for that step the barrier is where it gets by then, and that speed is what
/// it leaves of the velocity across itself.
struct Barrier {
    int axis;
    int side;         ///< +1: everything stays on the positive side of `place`; −1: on the other
    double place;     ///< m, on the axis
    double friction;  ///< Coulomb coefficient, 1

    /// m from the barrier at rest; negative: beyond it.
    double distance(const Vec3& x) const { return side * (x[axis] - place); }
    /// m: how far beyond something may be after a step that was `depth` beyond before it; 0 where
    /// that was not beyond.
    static double depthAfter(double depth, double pushSpeed, double step);
    /// What it leaves of a velocity, m/s.
    Vec3 stopped(const Vec3& velocity) const;
};

/// The floor, the walls at low and high x, those at low and high z, the ceiling: those there are.
/// The order in which every solver goes through them.
std::vector<Barrier> barriers(const WorldDescription&);

}  // namespace sunder::core
