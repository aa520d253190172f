// One step of symplectic Euler for every node, on joined groups, then the barriers.
#include "cpu/simd_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/cpu_nodes.cpp"
#include <hwy/foreach_target.h>

#include "cpu/cpu_kernels.hpp"
#include "cpu/simd_matrix-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sunder::cpu::HWY_NAMESPACE {

using namespace core;

using DI = hn::RebindToUnsigned<D>;
using DB = hn::Rebind<std::uint8_t, D>;
using VI = hn::Vec<DI>;

HWY_INLINE VI loadBytes(const std::uint8_t* from) {
    return hn::PromoteTo(DI(), hn::LoadU(DB(), from));
}

/// Lanes whose bits and `bit` have one in common.
HWY_INLINE Mask hasBit(VI bits, std::uint32_t bit) {
    return hn::RebindMask(d, hn::TestBit(bits, hn::Set(DI(), bit)));
}

/// Sum of the members' forces in octant order: the same for every member, to the bit.
template <int kMembers>
HWY_INLINE Vec3v groupForce(const BodyArrays& body, int corner, int cell, VI links) {
    const std::ptrdiff_t stride = body.stride;
    const V zero = hn::Zero(d);
    Vec3v sum{zero, zero, zero};
    const float* force = body.force + cell;
    const auto& members = body.members[corner];
    const int count = kMembers ? kMembers : body.memberCount;
    for (int i = 0; i < count; ++i) {
        const Mask joined = hasBit(links, members[i].bit);
        const float* from = force + members[i].offset;
        sum.x = sum.x + hn::IfThenElseZero(joined, hn::LoadU(d, from));
        sum.y = sum.y + hn::IfThenElseZero(joined, hn::LoadU(d, from + stride));
        sum.z = sum.z + hn::IfThenElseZero(joined, hn::LoadU(d, from + 2 * stride));
    }
    return sum;
}

template <int kAxis>
HWY_INLINE V& component(Vec3v& a) {
    return kAxis == 0 ? a.x : kAxis == 1 ? a.y : a.z;
}

/// Barrier::stopped() (core/room.hpp) for the lanes beyond a barrier, which begin the step again
/// from `bound`, their displacement there, or, where they were beyond it before, from as far on the
/// way back as they come. kSide: Barrier::side. Returns whether there are any.
template <int kAxis, int kSide>
HWY_INLINE bool stopAt(const BodyArrays& body, V bound, float friction, Vec3v& u, Vec3v& v,
                       Vec3v& next) {
    const auto outside = [&](V place) {
        const V x = component<kAxis>(next);
        return kSide > 0 ? hn::Lt(x, place) : hn::Gt(x, place);
    };
    const auto inwards = [](V x) { return kSide > 0 ? x : hn::Zero(d) - x; };
    if (HWY_LIKELY(!any(outside(bound)))) return false;
    const V zero = hn::Zero(d), one = set(1.f);
    const V depth = hn::Max(zero, inwards(bound - component<kAxis>(u)));
    const V back = hn::Min(depth * set(body.returnShare), set(body.returnWay));
    bound = bound - inwards(depth - back);
    const Mask beyond = outside(bound);
    const V into = zero - inwards(component<kAxis>(v));
    const V a = component<(kAxis + 2) % 3>(v), b = component<(kAxis + 1) % 3>(v);
    const V tangential = hn::Sqrt(a * a + b * b);
    const V taken = set(friction) * hn::Max(zero, into);
    const V kept = hn::IfThenElseZero(hn::Gt(tangential, taken), one - taken / tangential);
    Vec3v left = v * kept;
    component<kAxis>(left) = zero;
    v = select(beyond, left, v);
    component<kAxis>(u) = hn::IfThenElse(beyond, bound, component<kAxis>(u));
    next = select(beyond, u + v * set(body.step), next);
    component<kAxis>(v) =
        hn::IfThenElse(beyond, inwards(back) * set(1 / body.step), component<kAxis>(v));
    return true;
}

/// The room's two barriers across an axis. `rest`: m, the nodes' place on it at rest.
template <int kAxis>
HWY_INLINE bool stayBetween(const BodyArrays& body, V rest, Vec3v& u, Vec3v& v, Vec3v& next) {
    const V low = set(body.roomLow[kAxis]) - rest, high = set(body.roomHigh[kAxis]) - rest;
    const bool below = stopAt<kAxis, +1>(body, low, body.roomFriction, u, v, next);
    const bool above = stopAt<kAxis, -1>(body, high, body.roomFriction, u, v, next);
    return below || above;
}

/// All barriers, in the order of barriers(). `squared`: of the speed.
HWY_INLINE void stayInside(const BodyArrays& body, int corner, int cell, Vec3v u, Vec3v& v,
                           Vec3v& next, V& squared) {
    const auto rest = [&](int axis) {
        return hn::Load(d, body.rest[axis] + (corner >> axis & 1) * body.stride + cell);
    };
    bool stopped = false;
    if (body.ground) {
        const V floor = hn::Zero(d) - rest(1);
        stopped = stopAt<1, +1>(body, floor, body.groundFriction, u, v, next);
    }
    if (body.room) {
        stopped |= stayBetween<0>(body, rest(0), u, v, next);
        stopped |= stayBetween<2>(body, rest(2), u, v, next);
        stopped |= stayBetween<1>(body, rest(1), u, v, next);
    }
    if (HWY_UNLIKELY(stopped)) squared = dot(v, v);
}

/// Returns the squared speeds.
template <int kMembers>
HWY_INLINE V updateNode(const BodyArrays& body, int corner, int cell,
                        std::span<const Push> pushes) {
    const VI links = loadBytes(body.links + tiled(kCorners, corner, cell));
    const V inverseMass = hn::Load(d, body.inverseMass + tiled(kCorners, corner, cell));
    const Vec3v force = groupForce<kMembers>(body, corner, cell, links);
    Vec3v a = force * inverseMass +
              Vec3v{set(body.gravity[0]), set(body.gravity[1]), set(body.gravity[2])};
    for (const Push& push : pushes) {
        const Mask inside = hasBit(loadBytes(push.patch + cell), 1u << corner);
        if (!any(inside)) continue;
        a = {a.x + hn::IfThenElseZero(inside, set(push.acceleration[0])),
             a.y + hn::IfThenElseZero(inside, set(push.acceleration[1])),
             a.z + hn::IfThenElseZero(inside, set(push.acceleration[2]))};
    }
    const std::ptrdiff_t at = tiled(kNodeComponents, 3 * corner, cell);
    float* displacement = body.displacement + at;
    float* velocity = body.velocity + at;
    const Vec3v u = load3(displacement, kLanes);
    const V h = set(body.step);
    Vec3v v = load3(velocity, kLanes) * set(body.drag) + a * h;
    const Mask moves = hn::Gt(inverseMass, hn::Zero(d));
    v = {hn::IfThenElseZero(moves, v.x), hn::IfThenElseZero(moves, v.y),
         hn::IfThenElseZero(moves, v.z)};
    V squared = dot(v, v);
    Vec3v next = u + v * h;
    if (body.ground || body.room) stayInside(body, corner, cell, u, v, next, squared);
    store3(v, velocity, kLanes);
    store3(next, displacement, kLanes);
    return squared;
}

template <int kMembers>
float updateStretch(const BodyArrays& body, int first, int end, std::span<const Push> pushes) {
    V fastest = hn::Zero(d);
    for (int cell = first * kLanes; cell < end * kLanes; cell += kWidth)
        for (int corner = 0; corner < kCorners; ++corner)
            fastest = hn::Max(fastest, updateNode<kMembers>(body, corner, cell, pushes));
    return hn::GetLane(hn::MaxOfLanes(d, fastest));
}

float nodes(const BodyArrays& body, int first, int end, std::span<const Push> pushes) {
    switch (body.memberCount) {
        case 8:
            return updateStretch<8>(body, first, end, pushes);
        case 4:
            return updateStretch<4>(body, first, end, pushes);
        default:
            return updateStretch<0>(body, first, end, pushes);
    }
}

}  // namespace sunder::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sunder::cpu {

HWY_EXPORT(nodes);

float updateNodes(const BodyArrays& body, int first, int end, std::span<const Push> pushes) {
    return HWY_DYNAMIC_DISPATCH(nodes)(body, first, end, pushes);
}

std::span<const std::int64_t> simdTargets() {
#if HWY_TARGETS == HWY_STATIC_TARGET
    // It has no choice. Highway's library, which may know the one set by another name, is not
    // asked.
    static const std::vector<std::int64_t> targets{HWY_STATIC_TARGET};
#else
    static const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
#endif
    return targets;
}
const char* simdTargetName(std::int64_t target) {
    return hwy::TargetName(target);
}
void useSimdTarget(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace sunder::cpu
#endif
