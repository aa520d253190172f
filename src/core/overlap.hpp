#pragma once
#include <cstdint>
#include <vector>

#include "core/box_pairs.hpp"
#include "core/constants.hpp"

namespace sunder::core {

struct BodyDescription;
struct WorldDescription;

/// What may be in what when the world begins, and how it gets out.
///
/// Ground, room, bodies and objects must not be in each other then: contact would throw them apart
/// with whatever energy its springs find in the overlap, a square metre of half a cell's depth with
/// that of a car. So an overlap is refused, unless the scene marks one of the two (`mayOverlap`):
/// then it is parted at WorldDescription::partingSpeed at most, as is everything that comes to be
/// in something later (thrown there, say). Bodies count as the cells they have; fixed objects and
/// the ground or room do not touch. Overlaps between bodies matter only where cells touch.
///
/// Tolerated, for one thing set down exactly on another must pass, whatever its place was rounded
/// to:
/// - a hundredth of the shortest edge of the cells or objects involved, the smaller one's: nobody
///   sees that, and under load things lie in each other as deep;
/// - between bodies no more than V·h/√κ, V the parting speed, for a spring of stiffness κ·M/h² that
///   is pressed in by δ throws its ends apart at √κ·δ/h (core/contact.hpp);
/// - on top of it 2⁻²² of the coordinates, for solvers compute in single precision.
inline constexpr double kOverlapShare = 0.01;

// What parts things asks for a share U/V = kPushShare of the parting speed: what is elastic leaves
// at up to twice the speed it is pushed with. (A push f that ends where sides part at U does work
// of at most U·∫f = U·P, and two masses that got P have at least P²/2M, so P/M ≤ 2U and the work is
// at most ½·M·(2U)².) That is for pushes one way, and would allow a half; the rest is for boxes,
// whose corners are pushed several ways at once.

/// Two bodies that overlap as the world begins, one of which is marked, and the way out.
///
/// They push each other along `way`, not from the centre of a sphere to that of another: in the
/// middle of two lattices that are in each other those point to all sides.
struct Parting {
    int a = 0, b = 0;                  ///< bodies, a < b
    Vec3 low{0, 0, 0}, high{0, 0, 0};  ///< m: the overlap lasts while a has moved by that, from b
    Vec3 way{0, 1, 0};                 ///< unit vector: a's shortest way out along one of `axes`
    /// Columns, orthonormal: what `low` and `high` are measured along. Those of one of the bodies,
    /// along which they come apart sooner.
    Mat3 axes = Mat3::Identity();

    /// moved: m, displacement of a place in a less that of one in b.
    bool lasts(const Vec3& moved) const {
        const Vec3 along = axes.transpose() * moved;
        return (along.array() > low.array()).all() && (along.array() < high.array()).all();
    }
};
/// More pairs than that are refused.
inline constexpr std::size_t kMaxPartings = 1 << 16;

struct StartOverlaps {
    std::vector<Parting> partings;  ///< by a, then b
    std::int64_t compared = 0;      ///< boxes with boxes, for tests
};

/// Throws InputError for the first overlap that is refused: what is in what, and how deep.
StartOverlaps startOverlaps(const WorldDescription&);

/// A body's cells as few boxes, in the world: where they would lie were it not turned about its
/// position.
std::vector<Box> boxesOf(const BodyDescription&);

}  // namespace sunder::core
