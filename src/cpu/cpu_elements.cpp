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
//
// Vectors are along the body's own axes: those of a turned body are turned when they are read, and
// its forces when they are written. So F is exactly the identity at rest, whatever the axes.
#include "cpu/simd_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/cpu_elements.cpp"
#include <hwy/foreach_target.h>

#include "core/elasticity.hpp"
#include "cpu/cpu_kernels.hpp"
#include "cpu/simd_polar-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sunder::cpu::HWY_NAMESPACE {

using namespace core;

/// b is five times as large in strongly deformed elements.
constexpr float kHotRate = 5.f;

/// Corners at one end of the x edges of the four corner tetrahedra.
struct Corners {
    Vec3v t0, t1, t2, t3;
};

/// The end of x edge t that is the apex of tetrahedron t (kApex), or the other one. Apexes are
/// corners 1, 2, 4, 7; in mirrored cells 0, 3, 5, 6.
template <bool kApex, int kT>
HWY_INLINE Vec3v loadEnd(const float* tile, Mask mirrored) {
    constexpr bool high = kApex == (kT == 0 || kT == 3);
    const Vec3v low = load3(tile + 6 * kT * kLanes, kLanes);
    const Vec3v up = load3(tile + (6 * kT + 3) * kLanes, kLanes);
    return high ? select(mirrored, low, up) : select(mirrored, up, low);
}

HWY_INLINE Corners loadBases(const float* tile, Mask mirrored) {
    return {loadEnd<false, 0>(tile, mirrored), loadEnd<false, 1>(tile, mirrored),
            loadEnd<false, 2>(tile, mirrored), loadEnd<false, 3>(tile, mirrored)};
}

HWY_INLINE Mat3v axesOf(const BodyArrays& body) {
    const auto axis = [&](int i) HWY_ATTR {
        return Vec3v{set(body.axes[i][0]), set(body.axes[i][1]), set(body.axes[i][2])};
    };
    return {axis(0), axis(1), axis(2)};
}

/// A nodal field along the body's own axes: of a body that is not turned the tile itself; of any
/// other, `own` is filled as the tile is.
HWY_INLINE const float* alongAxes(const BodyArrays& body, const float* tile, float* own) {
    if (HWY_LIKELY(!body.turned)) return tile;
    const Mat3v axes = axesOf(body);
    for (int at = 0; at < kNodeComponents * kLanes; at += 3 * kLanes)
        store3(transposeTimes(axes, load3(tile + at, kLanes)), own + at, kLanes);
    return own;
}

/// Gradient of a nodal field in tetrahedron kT (4: the central one). `scale`: 1/edge times any
/// factor, x with the sign of `side`.
template <int kT>
HWY_INLINE Mat3v gradient(const Vec3v& apex, const Corners& base, const Vec3v& scale) {
    if constexpr (kT == 0)
        return {(apex - base.t0) * scale.x, (base.t1 - apex) * scale.y, (base.t2 - apex) * scale.z};
    else if constexpr (kT == 1)
        return {(base.t1 - apex) * scale.x, (apex - base.t0) * scale.y, (base.t3 - apex) * scale.z};
    else if constexpr (kT == 2)
        return {(base.t2 - apex) * scale.x, (base.t3 - apex) * scale.y, (apex - base.t0) * scale.z};
    else
        return {(apex - base.t3) * scale.x, (apex - base.t2) * scale.y, (apex - base.t1) * scale.z};
}

HWY_INLINE Mat3v centralGradient(const Corners& base, const Vec3v& scale) {
    const Vec3v a = base.t1 - base.t0, b = base.t3 - base.t2;
    const Vec3v c = base.t2 - base.t0, e = base.t3 - base.t1;
    const Vec3v half = scale * set(0.5f);
    return {(a - b) * half.x, (a + b) * half.y, (c + e) * half.z};
}

HWY_INLINE void addIdentity(Mat3v& m) {
    const V one = set(1.f);
    m.x.x = one + m.x.x;
    m.y.y = one + m.y.y;
    m.z.z = one + m.z.z;
}

/// Strongly deformed tetrahedra.
struct Hot {
    Mask lanes;
    Mat3v rate;  ///< b·h·Ḟ; kept only where there is one
};

/// G = F + b·h·Ḟ, from F and b·h·Ḟ.
HWY_INLINE Mat3v damped(const Mat3v& F, Mat3v rate, V hotDeterminant, Hot& hot) {
    hot.lanes = hn::Or(hn::Lt(determinant(F), hotDeterminant), hn::Gt(squaredNorm(F), set(6.f)));
    if (HWY_UNLIKELY(any(hot.lanes))) {
        hot.rate = rate;
        const V factor = hn::IfThenElse(hot.lanes, set(kHotRate), set(1.f));
        rate = {rate.x * factor, rate.y * factor, rate.z * factor};
    }
    return F + rate;
}

struct Elastic {
    V lambda, twoMu, corotated, hotDeterminant, largestStress;
};

HWY_INLINE Mat3v scaleColumns(const Mat3v& m, const Vec3v& s) {
    return {m.x * s.x, m.y * s.y, m.z * s.z};
}

/// First Piola–Kirchhoff stress P of A, its columns times `weight`, and the rotation R of A where
/// the law or `kStress` asks for it.
template <LawKind kKind, bool kStress>
HWY_INLINE Mat3v piola(const Mat3v& A, const Elastic& law, const Vec3v& weight, bool stiff,
                       Mat3v& R) {
    Mat3v P;
    if constexpr (kKind != LawKind::Green || kStress) {
        const Polar polar = polarNearIdentity(A, stiff);
        R = polar.R;
        // 2μ(A − R) + λ·(tr(S) − 3)·R
        const V pressure = law.lambda * (polar.trace - set(3.f)) - law.twoMu;
        P = scaleColumns(A, weight * law.twoMu) + scaleColumns(R, weight * pressure);
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
        const Mat3v full = A * S;
        const V size = squaredNorm(full), most = law.largestStress;
        const Mask over = hn::Gt(size, most * most);
        Vec3v scale = weight;
        if (HWY_UNLIKELY(any(over)))
            scale = scale * hn::IfThenElse(over, most / hn::Sqrt(size), one);
        const Mat3v green = scaleColumns(full, scale);
        P = kKind == LawKind::Green ? green : select(hn::Gt(law.corotated, half), P, green);
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

struct Symmetric {
    V xx, yy, zz, xy, yz, zx;
};

HWY_INLINE Symmetric cauchy(const Mat3v& F, const Mat3v& P) {
    const V factor = set(0.5f) / hn::Max(determinant(F), set(0.05f));
    const auto entry = [&](V Vec3v::*row, V Vec3v::*column) HWY_ATTR {
        return factor *
               ((P.x.*row * F.x.*column + P.y.*row * F.y.*column + P.z.*row * F.z.*column) +
                (P.x.*column * F.x.*row + P.y.*column * F.y.*row + P.z.*column * F.z.*row));
    };
    return {entry(&Vec3v::x, &Vec3v::x), entry(&Vec3v::y, &Vec3v::y), entry(&Vec3v::z, &Vec3v::z),
            entry(&Vec3v::x, &Vec3v::y), entry(&Vec3v::y, &Vec3v::z), entry(&Vec3v::z, &Vec3v::x)};
}

/// Whether the largest eigenvalue of a stress exceeds `limit`: limit·I − σ is then not positive
/// definite, and its elimination meets a pivot that is not positive.
HWY_INLINE Mask exceeds(const Symmetric& stress, V limit) {
    const V xx = limit - stress.xx, yy = limit - stress.yy, zz = limit - stress.zz;
    const V xy = stress.xy, yz = stress.yz, zx = stress.zx;
    const V ly = xy / xx, lz = zx / xx;
    const V second = yy - ly * xy;
    const V cross = yz + ly * zx;
    const V third = zz - lz * zx - cross / second * cross;
    const V zero = hn::Zero(d);
    return hn::Or(hn::Lt(xx, zero), hn::Or(hn::Lt(second, zero), hn::Lt(third, zero)));
}

/// With A = mean·I + p·B, where p makes tr(B²) = 6, the eigenvalues of B are the roots of
/// y³ − 3y = det(B); the largest is 1 + t with t²·(3 + t) = det(B) + 2, t from 0 to 1.
HWY_INLINE V largestEigenvalue(const Symmetric& a) {
    const V third = set(1.f / 3), three = set(3.f), tiny = set(1e-30f);
    const V mean = third * (a.xx + a.yy + a.zz);
    const V xx = a.xx - mean, yy = a.yy - mean, zz = a.zz - mean;
    const V squares =
        xx * xx + yy * yy + zz * zz + set(2.f) * (a.xy * a.xy + a.yz * a.yz + a.zx * a.zx);
    const V p = hn::Sqrt(squares * set(1.f / 6));
    const V det = xx * (yy * zz - a.yz * a.yz) - a.xy * (a.xy * zz - a.yz * a.zx) +
                  a.zx * (a.xy * a.yz - yy * a.zx);
    const V q = hn::Max(hn::Zero(d), det / hn::Max(p * p * p, tiny) + set(2.f));
    const V start = hn::Sqrt(third * q);
    V t = start / (set(1.f) + set(0.134f) * start);  // exact at 0 and at 1
    for (int i = 0; i < 2; ++i)
        t = t - (t * t * (three + t) - q) / hn::Max(three * t * (set(2.f) + t), tiny);
    return mean + p * (set(1.f) + t);
}

/// A stretch of cells in progress: what all its tetrahedra share.
struct Cells {
    const BodyArrays& body;
    int first;
    const float *displacement, *velocity;  ///< tiles, along the body's own axes
    Mask mirrored;
    Vec3v scale;   ///< 1/edge, x with the sign of `side`
    Vec3v weight;  ///< volume/(6·edge), likewise
    Elastic law;
    Corners u, v;  ///< displacements and velocities of the bases
    Mat3v frame;   ///< turns with the cell, as damping sees it
    Mat3v back;    ///< the same as the cell is now: turnedBack() of core/elasticity.hpp; from there
                   ///< to the world
    Corners force;  ///< on the bases, in that frame
};

/// What fracture wants of a cell's tetrahedra besides their forces.
struct StressOutput {
    V limit;    ///< what its largest principal stress may be
    V largest;  ///< that; only with BodyArrays::slowStress
    Mask over;  ///< some tetrahedron exceeds the limit
};

/// P of tetrahedron number kT (4: the central one) in the cell's frame, its columns weighted.
template <LawKind kKind, bool kStress, int kT>
HWY_INLINE Mat3v tetrahedron(const Cells& cells, const Mat3v& F, const Mat3v& G, const Hot& hot,
                             [[maybe_unused]] StressOutput* out) {
    const Mat3v A = transposeTimes(cells.frame, G);
    Mat3v R;
    Mat3v P = piola<kKind, kStress>(A, cells.law, cells.weight, cells.body.stiff, R);
    if (HWY_UNLIKELY(any(hot.lanes))) {
        const LawLookup lookup{&cells.body, cells.first};
        const V factor = hn::IfThenElse(hot.lanes, lookup(&Law::hotStress), set(1.f));
        const V viscosity = hn::IfThenElseZero(hot.lanes, lookup(&Law::hotRate));
        P = Mat3v{P.x * factor, P.y * factor, P.z * factor} +
            scaleColumns(transposeTimes(cells.frame, hot.rate), cells.weight * viscosity);
    }
    if constexpr (kStress) {
        const BodyArrays& body = cells.body;
        const V one = set(1.f);
        const Mat3v plain =
            scaleColumns(P, {one / cells.weight.x, one / cells.weight.y, one / cells.weight.z});
        if (kT < 4 && body.bondsBreak)
            storeBiot(R, plain, body.stress + 6 * kT * body.stride + cells.first, body.stride);
        if (body.cellsBreak) {
            const Symmetric stress = cauchy(transposeTimes(cells.frame, F), plain);
            out->over = hn::Or(out->over, exceeds(stress, out->limit));
            if (body.slowStress) out->largest = hn::Max(out->largest, largestEigenvalue(stress));
        }
    }
    return P;
}

/// Works out a corner tetrahedron; returns the force on its apex and adds those on the bases.
template <LawKind kKind, bool kStress, int kT>
HWY_INLINE Vec3v cornerTetrahedron(Cells& cells, StressOutput* out) {
    const BodyArrays& body = cells.body;
    const Vec3v u = loadEnd<true, kT>(cells.displacement, cells.mirrored);
    const Vec3v v = loadEnd<true, kT>(cells.velocity, cells.mirrored);
    Mat3v F = gradient<kT>(u, cells.u, cells.scale);
    addIdentity(F);
    Hot hot;
    const Mat3v G = damped(F, gradient<kT>(v, cells.v, cells.scale * set(body.dampingTime)),
                           cells.law.hotDeterminant, hot);
    const Mat3v P = tetrahedron<kKind, kStress, kT>(cells, F, G, hot, out);
    // −V·P·∇N: the columns of P, weighted, pull at the ends of the edges that F's columns are made
    // of, with the opposite sign.
    Corners& f = cells.force;
    if constexpr (kT == 0) {
        f.t0 = f.t0 + P.x;
        f.t1 = f.t1 - P.y;
        f.t2 = f.t2 - P.z;
        return (P.y + P.z) - P.x;
    } else if constexpr (kT == 1) {
        f.t0 = f.t0 + P.y;
        f.t1 = f.t1 - P.x;
        f.t3 = f.t3 - P.z;
        return (P.x + P.z) - P.y;
    } else if constexpr (kT == 2) {
        f.t0 = f.t0 + P.z;
        f.t2 = f.t2 - P.x;
        f.t3 = f.t3 - P.y;
        return (P.x + P.y) - P.z;
    } else {
        f.t1 = f.t1 + P.z;
        f.t2 = f.t2 + P.y;
        f.t3 = f.t3 + P.x;
        const V zero = hn::Zero(d);
        return Vec3v{zero, zero, zero} - ((P.x + P.y) + P.z);
    }
}

/// The central tetrahedron; also chooses the cell's frame.
template <LawKind kKind, bool kStress>
HWY_INLINE void centralTetrahedron(Cells& cells, StressOutput* out) {
    Mat3v F = centralGradient(cells.u, cells.scale);
    addIdentity(F);
    Hot hot;
    const Mat3v change = centralGradient(cells.v, cells.scale * set(cells.body.dampingTime));
    const Mat3v G = damped(F, change, cells.law.hotDeterminant, hot);
    cells.frame = gramSchmidt(G);
    const Mask asOne = hn::And(hn::Lt(squaredNorm(change), set(static_cast<float>(kMostTurn2))),
                               hn::Lt(squaredNorm(F), set(static_cast<float>(kMostStretch2))));
    const Mask turns = hn::AndNot(hot.lanes, asOne);
    cells.back = select(turns, gramSchmidt(F), cells.frame);
    if (HWY_UNLIKELY(cells.body.turned)) cells.back = axesOf(cells.body) * cells.back;
    const Mat3v P = tetrahedron<kKind, kStress, 4>(cells, F, G, hot, out);
    cells.force = {(P.x + P.y) + P.z, P.z - (P.x + P.y), P.y - (P.x + P.z), P.x - (P.y + P.z)};
}

/// Turns the forces on the ends of an x edge back into the world.
template <int kT>
HWY_INLINE void storeEnds(const Cells& cells, const Vec3v& apex, const Vec3v& base) {
    const std::ptrdiff_t stride = cells.body.stride;
    float* force = cells.body.force + cells.first + 6 * kT * stride;
    constexpr bool high = kT == 0 || kT == 3;
    const Vec3v a = cells.back * apex, b = cells.back * base;
    const Vec3v &usually = high ? b : a, &mirrored = high ? a : b;
    store3(select(cells.mirrored, mirrored, usually), force, stride);
    store3(select(cells.mirrored, usually, mirrored), force + 3 * stride, stride);
}

/// Lanes whose cells break by their stress and lose some of it to the limit of E.
HWY_INLINE Mask hasSlowStress(const LawLookup& law) {
    return hn::And(hn::Lt(law(&Law::maxStress), set(kUnbreakable)),
                   hn::Gt(law(&Law::stressScale), set(1.f)));
}

/// The stress at which the slow part plus S times what exceeds it is the material's limit.
HWY_INLINE V stressLimit(const BodyArrays& body, int first) {
    const LawLookup law{&body, first};
    const V most = law(&Law::maxStress);
    if (!body.slowStress) return most;
    const V slow = hn::Load(d, body.slowStress + first);
    const V limit = hn::IfThenElse(hn::Gt(slow, most), set(-kUnbreakable),
                                   slow + (most - slow) / law(&Law::stressScale));
    return hn::IfThenElse(hasSlowStress(law), limit, most);
}

HWY_INLINE void keepSlowStress(const BodyArrays& body, int first, V largest) {
    const V slow = hn::Load(d, body.slowStress + first);
    const V now = slow + (largest - slow) * set(body.slowShare);
    hn::Store(hn::IfThenElse(hasSlowStress({&body, first}), now, slow), d, body.slowStress + first);
}

template <LawKind kKind, bool kStress>
HWY_INLINE void updateCells(const BodyArrays& body, int first) {
    const V side = hn::Load(d, body.side + first);
    const Mask mirrored = hn::Lt(side, hn::Zero(d));
    const LawLookup lookup{&body, first};
    const std::ptrdiff_t tile = tiled(kNodeComponents, 0, first);
    HWY_ALIGN float ownDisplacement[kNodeComponents * kLanes];
    HWY_ALIGN float ownVelocity[kNodeComponents * kLanes];
    const float* displacement = alongAxes(body, body.displacement + tile, ownDisplacement);
    const float* velocity = alongAxes(body, body.velocity + tile, ownVelocity);
    Cells cells{
        body,
        first,
        displacement,
        velocity,
        mirrored,
        {side * set(body.inverseCell[0]), set(body.inverseCell[1]), set(body.inverseCell[2])},
        {side * set(body.forceWeight[0]), set(body.forceWeight[1]), set(body.forceWeight[2])},
        {lookup(&Law::lambda), lookup(&Law::twoMu), lookup(&Law::corotated),
         lookup(&Law::hotDeterminant), lookup(&Law::largestStress)},
        loadBases(displacement, mirrored),
        loadBases(velocity, mirrored),
        {},
        {},
        {}};
    StressOutput* out = nullptr;
    [[maybe_unused]] StressOutput stress;
    if constexpr (kStress) {
        stress = {stressLimit(body, first), hn::Zero(d), hn::Lt(side, side)};
        out = &stress;
    }
    centralTetrahedron<kKind, kStress>(cells, out);
    const Vec3v apex0 = cornerTetrahedron<kKind, kStress, 0>(cells, out);
    const Vec3v apex1 = cornerTetrahedron<kKind, kStress, 1>(cells, out);
    const Vec3v apex2 = cornerTetrahedron<kKind, kStress, 2>(cells, out);
    const Vec3v apex3 = cornerTetrahedron<kKind, kStress, 3>(cells, out);
    storeEnds<0>(cells, apex0, cells.force.t0);
    storeEnds<1>(cells, apex1, cells.force.t1);
    storeEnds<2>(cells, apex2, cells.force.t2);
    storeEnds<3>(cells, apex3, cells.force.t3);
    if constexpr (kStress) {
        if (body.cellsBreak)
            hn::Store(hn::IfThenElseZero(out->over, set(1.f)), d, body.over + first);
        if (body.slowStress) keepSlowStress(body, first, out->largest);
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
