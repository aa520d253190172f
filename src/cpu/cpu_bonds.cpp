// Fracture: overstressed cells leave their neighbours, and bonds take damage from their traction.
#include "cpu/simd_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/cpu_bonds.cpp"
#include <hwy/foreach_target.h>

#include "cpu/cpu_kernels.hpp"
#include "cpu/simd_matrix-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sunder::cpu::HWY_NAMESPACE {

using namespace core;

/// Components of a symmetric stress xx yy zz xy yz zx: those of a face with normal x, y, z.
constexpr int kShear[3][2] = {{3, 5}, {3, 4}, {5, 4}};
/// Tetrahedra (number: apex >> 1) whose apex lies on the +x, +y, +z face; in a mirrored cell those
/// of the +x face are 1 and 2. The neighbour's at the same place have the number with one bit
/// flipped, none for x.
constexpr int kOnFace[3][2] = {{0, 3}, {1, 3}, {2, 3}};

struct Traction {
    V normal, shear;
};

/// Mean stress of the two tetrahedra that meet at one triangle of the face, on that face.
HWY_INLINE Traction faceTraction(const BodyArrays& body, int cell, int axis, int t) {
    const float* mine = body.stress + 6 * t * body.stride + cell;
    const float* theirs =
        body.stress + 6 * (t ^ (1 << axis >> 1)) * body.stride + cell + body.steps[axis];
    const V half = set(0.5f);
    const auto mean = [&](int component) HWY_ATTR {
        return half * (hn::Load(d, mine + component * body.stride) +
                       hn::LoadU(d, theirs + component * body.stride));
    };
    const V b = mean(kShear[axis][0]), c = mean(kShear[axis][1]);
    return {mean(axis), hn::Sqrt(b * b + c * c)};
}

HWY_INLINE Traction select(Mask m, const Traction& yes, const Traction& no) {
    return {hn::IfThenElse(m, yes.normal, no.normal), hn::IfThenElse(m, yes.shear, no.shear)};
}

/// docs/fracture.md, points 3 to 7, for the lanes in `holds`.
HWY_INLINE void loadBond(const BodyArrays& body, int cell, int axis, float interval, Mask holds,
                         V strength, V& damage, V& slow) {
    Traction first = faceTraction(body, cell, axis, kOnFace[axis][0]);
    Traction second = faceTraction(body, cell, axis, kOnFace[axis][1]);
    if (axis == 0) {
        const Mask mirrored = hn::Lt(hn::Load(d, body.side + cell), hn::Zero(d));
        first = select(mirrored, faceTraction(body, cell, 0, 1), first);
        second = select(mirrored, faceTraction(body, cell, 0, 2), second);
    }
    const LawLookup law{&body, cell};
    const V zero = hn::Zero(d), half = set(0.5f), S = law(&Law::stressScale);
    const V tn =
        S * (half * (first.normal + second.normal) + hn::Abs(first.normal - second.normal));
    const V ts = hn::Max(zero, S * half * (first.shear + second.shear) -
                                   law(&Law::friction) * hn::Max(zero - tn, zero));
    const V tension = hn::Max(tn, zero);
    const V unscaled = hn::Sqrt(tension * tension + law(&Law::shearWeight) * ts * ts) / S;
    const V newSlow = slow + (unscaled - slow) * set(body.slowShare);
    const V blow = hn::Max(zero, unscaled - newSlow);
    const V ratio = (newSlow + S * blow) / strength;
    const V rate = set(interval) * law(&Law::damageRate);
    const V grown = hn::Min(set(1.f), damage + rate * hn::Min(ratio - set(1.f), set(4.f)));
    damage = hn::IfThenElse(hn::And(holds, hn::Gt(ratio, set(1.f))), grown, damage);
    const Mask sudden =
        hn::And(hn::Gt(blow, law(&Law::suddenTraction)),
                hn::Gt(S * S * blow, set(static_cast<float>(kSuddenStress)) * strength));
    damage = hn::IfThenElse(hn::And(holds, sudden), set(1.f), damage);
    slow = hn::IfThenElse(holds, newSlow, slow);
}

BondNews bonds(const BodyArrays& body, int first, int end, float interval) {
    BondNews news;
    const V one = set(1.f);
    for (int cell = first * kLanes; cell < end * kLanes; cell += kWidth)
        for (int axis = 0; axis < 3; ++axis) {
            if (body.extent[axis] == 1) continue;
            float* damages = body.damage + axis * body.stride + cell;
            const V before = hn::Load(d, damages);
            Mask holds = hn::Lt(before, one);
            if (!any(holds)) continue;
            V damage = before;
            if (body.cellsBreak) {
                const V over = hn::Max(hn::Load(d, body.over + cell),
                                       hn::LoadU(d, body.over + cell + body.steps[axis]));
                const Mask leaves = hn::And(holds, hn::Gt(over, hn::Zero(d)));
                damage = hn::IfThenElse(leaves, one, damage);
                holds = hn::AndNot(leaves, holds);
            }
            const V strength = hn::Load(d, body.strength + axis * body.stride + cell);
            holds = hn::And(holds, hn::Lt(strength, set(kUnbreakable)));
            if (body.bondsBreak && any(holds)) {
                float* slows = body.slow + axis * body.stride + cell;
                V slow = hn::Load(d, slows);
                loadBond(body, cell, axis, interval, holds, strength, damage, slow);
                hn::Store(slow, d, slows);
            }
            const Mask grew = hn::Gt(damage, before);
            if (!any(grew)) continue;
            hn::Store(damage, d, damages);
            news.damaged = true;
            const Mask broke = hn::And(grew, hn::Ge(damage, one));
            if (!any(broke)) continue;
            news.broke = true;
            HWY_ALIGN float flags[kWidth];
            hn::Store(hn::IfThenElseZero(broke, one), d, flags);
            for (int lane = 0; lane < kWidth; ++lane)
                if (flags[lane] != 0)
                    body.broke[cell + lane] =
                        static_cast<std::uint8_t>(body.broke[cell + lane] | 1 << axis);
        }
    return news;
}

}  // namespace sunder::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sunder::cpu {

HWY_EXPORT(bonds);

BondNews updateBonds(const BodyArrays& body, int first, int end, float interval) {
    return HWY_DYNAMIC_DISPATCH(bonds)(body, first, end, interval);
}

}  // namespace sunder::cpu
#endif
