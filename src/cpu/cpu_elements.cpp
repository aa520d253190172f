// Forces of a cell's five tetrahedra on its eight nodes.
//
// On a box cell the columns of a corner tetrahedron's F are the cell's edges at its apex over their
// lengths, and the central one's are half sums and differences of its four corners. Cells of the
// other parity are mirrored in x: in both, tetrahedron t = 0..3 has its apex on the cell's x edge
// number t (corners 2t and 2t+1), at the end ("apex") that `side` tells; the other end ("base") is
// a corner of the central one.
//
// All is worked out in one frame per cell that turns with it (Gram–Schmidt of the central
// tetrahedron): there every F is near the identity, and its rotation is found in one go.
#include "cpu/simd_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/cpu_elements.cpp"
#include <hwy/foreach_target.h>

#include "cpu/cpu_kernels.hpp"
#include "cpu/simd_polar-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sunder::cpu::HWY_NAMESPACE {

/// b is five times as large in strongly deformed elements, and their stress smaller, which keeps
/// the stability limit E·(1+2b).
constexpr float kHotRate = 5.f, kHotStress = 1.2f / 2.f;

/// A field at the ends of the x edge of tetrahedron t.
struct Ends {
    Vec3v apex, base;
};

/// Gradients of a nodal field: corner tetrahedra, then the central one.
struct Gradients {
    Mat3v t0, t1, t2, t3, t4;
};

template <bool kFlipped>
HWY_INLINE Ends loadEnds(const float* field, std::ptrdiff_t stride, int t, Mask mirrored) {
    const Vec3v low = load3(field + 6 * t * stride, stride);
    const Vec3v high = load3(field + (6 * t + 3) * stride, stride);
    return kFlipped ? Ends{select(mirrored, high, low), select(mirrored, low, high)}
                    : Ends{select(mirrored, low, high), select(mirrored, high, low)};
}

/// `scale`: 1/edge times any factor, x with the sign of `side`.
HWY_INLINE Gradients gradients(const float* field, std::ptrdiff_t stride, Mask mirrored,
                               const Vec3v& scale) {
    const Ends e0 = loadEnds<false>(field, stride, 0, mirrored);
    const Ends e1 = loadEnds<true>(field, stride, 1, mirrored);
    const Ends e2 = loadEnds<true>(field, stride, 2, mirrored);
    const Ends e3 = loadEnds<false>(field, stride, 3, mirrored);
    Gradients g;
    g.t0 = {(e0.apex - e0.base) * scale.x, (e1.base - e0.apex) * scale.y,
            (e2.base - e0.apex) * scale.z};
    g.t1 = {(e1.base - e1.apex) * scale.x, (e1.apex - e0.base) * scale.y,
            (e3.base - e1.apex) * scale.z};
    g.t2 = {(e2.base - e2.apex) * scale.x, (e3.base - e2.apex) * scale.y,
            (e2.apex - e0.base) * scale.z};
    g.t3 = {(e3.apex - e3.base) * scale.x, (e3.apex - e2.base) * scale.y,
            (e3.apex - e1.base) * scale.z};
    const V half = set(0.5f);
    g.t4 = {((e1.base + e2.base) - (e0.base + e3.base)) * (half * scale.x),
            ((e1.base - e0.base) + (e3.base - e2.base)) * (half * scale.y),
            ((e2.base - e0.base) + (e3.base - e1.base)) * (half * scale.z)};
    return g;
}

HWY_INLINE void addIdentity(Mat3v& m) {
    const V one = set(1.f);
    m.x.x = one + m.x.x;
    m.y.y = one + m.y.y;
    m.z.z = one + m.z.z;
}

/// Turns F (in) into G = F + b·h·Ḟ (out). `rate`: b·h·Ḟ.
HWY_INLINE Mask damped(Mat3v& F, Mat3v rate) {
    addIdentity(F);
    const Mask hot = hn::Or(hn::Lt(determinant(F), set(0.3f)), hn::Gt(squaredNorm(F), set(6.f)));
    if (HWY_UNLIKELY(any(hot))) {
        const V factor = hn::IfThenElse(hot, set(kHotRate), set(1.f));
        rate = {rate.x * factor, rate.y * factor, rate.z * factor};
    }
    F = F + rate;
    return hot;
}

struct Elastic {
    V lambda, twoMu, corotated;
};

/// First Piola–Kirchhoff stress P of A, and its rotation R where the caller wants it.
template <LawKind kKind, bool kStress>
HWY_INLINE Mat3v piola(const Mat3v& A, const Elastic& law, Mask hot, Mat3v& R) {
    Mat3v P;
    if constexpr (kKind != LawKind::Green || kStress) R = polarNearIdentity(A);
    if constexpr (kKind != LawKind::Green) {
        const V dilation = dot(R.x, A.x) + dot(R.y, A.y) + dot(R.z, A.z) - set(3.f);
        const V pressure = law.lambda * dilation;
        P = {(A.x - R.x) * law.twoMu + R.x * pressure, (A.y - R.y) * law.twoMu + R.y * pressure,
             (A.z - R.z) * law.twoMu + R.z * pressure};
    }
    if constexpr (kKind != LawKind::Corotated) {
        // Green's strain (thesis, eq. 2.2): E = ½(GᵀG − I), S = 2μE + λ·tr(E)·I, P = G·S.
        const V half = set(0.5f), one = set(1.f);
        const V xx = half * (dot(A.x, A.x) - one), yy = half * (dot(A.y, A.y) - one),
                zz = half * (dot(A.z, A.z) - one);
        const V xy = law.twoMu * (half * dot(A.x, A.y)), yz = law.twoMu * (half * dot(A.y, A.z)),
                zx = law.twoMu * (half * dot(A.z, A.x));
        const V pressure = law.lambda * (xx + yy + zz);
        const Mat3v S{{law.twoMu * xx + pressure, xy, zx},
                      {xy, law.twoMu * yy + pressure, yz},
                      {zx, yz, law.twoMu * zz + pressure}};
        const Mat3v green = A * S;
        P = kKind == LawKind::Green ? green : select(hn::Gt(law.corotated, half), P, green);
    }
    if (HWY_UNLIKELY(any(hot))) {
        const V factor = hn::IfThenElse(hot, set(kHotStress), set(1.f));
        P = {P.x * factor, P.y * factor, P.z * factor};
    }
    return P;
}

/// Biot stress in the material frame, T = sym(RᵀP): what bonds are tested with.
HWY_INLINE void storeBiot(const Mat3v& R, const Mat3v& P, float* to, std::ptrdiff_t stride) {
    const V half = set(0.5f);
    hn::Store(dot(R.x, P.x), d, to);
    hn::Store(dot(R.y, P.y), d, to + stride);
    hn::Store(dot(R.z, P.z), d, to + 2 * stride);
    hn::Store(half * (dot(R.x, P.y) + dot(R.y, P.x)), d, to + 3 * stride);
    hn::Store(half * (dot(R.y, P.z) + dot(R.z, P.y)), d, to + 4 * stride);
    hn::Store(half * (dot(R.z, P.x) + dot(R.x, P.z)), d, to + 5 * stride);
}

/// Whether the largest eigenvalue of the scaled Cauchy stress exceeds `limit`: limit·I − σ is then
/// not positive definite, and its elimination meets a pivot that is not positive.
HWY_INLINE Mask exceeds(const Mat3v& F, const Mat3v& P, V scale, V limit) {
    const V factor = set(0.5f) * scale / hn::Max(determinant(F), set(0.05f));
    const auto entry = [&](V Vec3v::*row, V Vec3v::*column) HWY_ATTR {
        return factor *
               ((P.x.*row * F.x.*column + P.y.*row * F.y.*column + P.z.*row * F.z.*column) +
                (P.x.*column * F.x.*row + P.y.*column * F.y.*row + P.z.*column * F.z.*row));
    };
    const V xx = limit - entry(&Vec3v::x, &Vec3v::x), yy = limit - entry(&Vec3v::y, &Vec3v::y),
            zz = limit - entry(&Vec3v::z, &Vec3v::z);
    const V xy = entry(&Vec3v::x, &Vec3v::y), yz = entry(&Vec3v::y, &Vec3v::z),
            zx = entry(&Vec3v::z, &Vec3v::x);
    const V ly = xy / xx, lz = zx / xx;
    const V second = yy - ly * xy;
    const V cross = yz + ly * zx;
    const V third = zz - lz * zx - cross / second * cross;
    const V zero = hn::Zero(d);
    return hn::Or(hn::Lt(xx, zero), hn::Or(hn::Lt(second, zero), hn::Lt(third, zero)));
}

/// What fracture wants of a cell's tetrahedra besides their forces.
struct StressOutput {
    const BodyArrays* body;
    int cell;
    V scale, limit;  ///< S, and what S times the Cauchy stress may be
    Mask over;       ///< some tetrahedron exceeds the limit
};

/// P of tetrahedron number kT (4: the central one) in the cell's frame, its columns times `weight`.
template <LawKind kKind, bool kStress, int kT>
HWY_INLINE Mat3v tetrahedron(const Mat3v& frame, const Vec3v& weight, const Elastic& law,
                             const Mat3v& G, Mask hot, [[maybe_unused]] const Mat3v* F,
                             [[maybe_unused]] StressOutput* out) {
    const Mat3v A = transposeTimes(frame, G);
    Mat3v R;
    const Mat3v P = piola<kKind, kStress>(A, law, hot, R);
    if constexpr (kStress) {
        const BodyArrays& body = *out->body;
        if (kT < 4 && body.bondsBreak)
            storeBiot(R, P, body.stress + 6 * kT * body.stride + out->cell, body.stride);
        if (body.cellsBreak)
            out->over =
                hn::Or(out->over, exceeds(transposeTimes(frame, *F), P, out->scale, out->limit));
    }
    return {P.x * weight.x, P.y * weight.y, P.z * weight.z};
}

/// Turns the forces on the ends of an x edge back into the world.
template <bool kFlipped>
HWY_INLINE void storeEnds(const Mat3v& frame, const Vec3v& apex, const Vec3v& base, Mask mirrored,
                          float* force, std::ptrdiff_t stride, int t) {
    const Mask apexIsLow = kFlipped ? hn::Not(mirrored) : mirrored;
    const Vec3v a = frame * apex, b = frame * base;
    store3(select(apexIsLow, a, b), force + 6 * t * stride, stride);
    store3(select(apexIsLow, b, a), force + (6 * t + 3) * stride, stride);
}

template <LawKind kKind, bool kStress>
HWY_INLINE void updateCells(const BodyArrays& body, int cell) {
    const std::ptrdiff_t stride = body.stride;
    const V side = hn::Load(d, body.side + cell);
    const Mask mirrored = hn::Lt(side, hn::Zero(d));
    const Vec3v scale{side * set(body.inverseCell[0]), set(body.inverseCell[1]),
                      set(body.inverseCell[2])};
    Gradients g = gradients(body.displacement + cell, stride, mirrored, scale);
    const Gradients rate =
        gradients(body.velocity + cell, stride, mirrored, scale * set(body.dampingTime));
    const LawLookup lookup{&body, cell};
    const Elastic law{lookup(&Law::lambda), lookup(&Law::twoMu), lookup(&Law::corotated)};
    StressOutput* out = nullptr;
    [[maybe_unused]] StressOutput stressOutput;
    [[maybe_unused]] Gradients F;
    if constexpr (kStress) {
        stressOutput = {&body, cell, lookup(&Law::stressScale), lookup(&Law::maxStress),
                        hn::Lt(side, side)};
        out = &stressOutput;
        F = g;
        for (Mat3v* m : {&F.t0, &F.t1, &F.t2, &F.t3, &F.t4}) addIdentity(*m);
    }
    const Mask hot0 = damped(g.t0, rate.t0), hot1 = damped(g.t1, rate.t1),
               hot2 = damped(g.t2, rate.t2), hot3 = damped(g.t3, rate.t3),
               hot4 = damped(g.t4, rate.t4);
    const Mat3v frame = gramSchmidt(g.t4);
    const Vec3v weight{side * set(body.forceWeight[0]), set(body.forceWeight[1]),
                       set(body.forceWeight[2])};

    // −V·P·∇N: the columns of P, weighted, pull at the ends of the edges that F's columns are made
    // of (gradients() above), with the opposite sign.
    const Mat3v c = tetrahedron<kKind, kStress, 4>(frame, weight, law, g.t4, hot4, &F.t4, out);
    const Mat3v p0 = tetrahedron<kKind, kStress, 0>(frame, weight, law, g.t0, hot0, &F.t0, out);
    const Mat3v p1 = tetrahedron<kKind, kStress, 1>(frame, weight, law, g.t1, hot1, &F.t1, out);
    const Mat3v p2 = tetrahedron<kKind, kStress, 2>(frame, weight, law, g.t2, hot2, &F.t2, out);
    const Mat3v p3 = tetrahedron<kKind, kStress, 3>(frame, weight, law, g.t3, hot3, &F.t3, out);

    float* force = body.force + cell;
    storeEnds<false>(frame, (p0.y + p0.z) - p0.x, ((c.x + c.y) + c.z) + ((p0.x + p1.y) + p2.z),
                     mirrored, force, stride, 0);
    storeEnds<true>(frame, (p1.x + p1.z) - p1.y, (c.z - (c.x + c.y)) - ((p1.x + p0.y) - p3.z),
                    mirrored, force, stride, 1);
    storeEnds<true>(frame, (p2.x + p2.y) - p2.z, (c.y - (c.x + c.z)) - ((p2.x + p0.z) - p3.y),
                    mirrored, force, stride, 2);
    const V zero = hn::Zero(d);
    storeEnds<false>(frame, Vec3v{zero, zero, zero} - ((p3.x + p3.y) + p3.z),
                     (c.x - (c.y + c.z)) + (p3.x - (p2.y + p1.z)), mirrored, force, stride, 3);
    if constexpr (kStress) {
        if (body.cellsBreak)
            hn::Store(hn::IfThenElseZero(out->over, set(1.f)), d, body.over + cell);
    }
}

template <LawKind kKind>
void updateStretch(const BodyArrays& body, int first, int end, bool stress) {
    if (stress)
        for (int cell = first * kLanes; cell < end * kLanes; cell += kWidth)
            updateCells<kKind, true>(body, cell);
    else
        for (int cell = first * kLanes; cell < end * kLanes; cell += kWidth)
            updateCells<kKind, false>(body, cell);
}

void elements(const BodyArrays& body, int first, int end, bool stress) {
    switch (body.kind) {
        case LawKind::Green:
            return updateStretch<LawKind::Green>(body, first, end, stress);
        case LawKind::Corotated:
            return updateStretch<LawKind::Corotated>(body, first, end, stress);
        case LawKind::Mixed:
            return updateStretch<LawKind::Mixed>(body, first, end, stress);
    }
}

}  // namespace sunder::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sunder::cpu {

HWY_EXPORT(elements);

void updateElements(const BodyArrays& body, int first, int end, bool stress) {
    HWY_DYNAMIC_DISPATCH(elements)(body, first, end, stress);
}

}  // namespace sunder::cpu
#endif
