// Rotation R of the polar decomposition A = R·S, for many matrices at once. Compiled once per
// instruction set. Every lane depends on its own matrix alone: one that has converged does not
// move.
#if defined(SUNDER_CPU_SIMD_POLAR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SUNDER_CPU_SIMD_POLAR_INL
#undef SUNDER_CPU_SIMD_POLAR_INL
#else
#define SUNDER_CPU_SIMD_POLAR_INL
#endif

#include "cpu/simd_matrix-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sunder::cpu::HWY_NAMESPACE {

HWY_INLINE Vec3v perpendicular(const Vec3v& a) {
    const V zero = hn::Zero(d);
    const Vec3v fromX{zero, a.z, zero - a.y}, fromY{zero - a.z, zero, a.x};
    const Vec3v p = select(hn::Lt(hn::Abs(a.x), set(0.6f)), fromX, fromY);
    return p * (set(1.f) / hn::Sqrt(dot(p, p)));
}

/// An orthonormal frame whose first axes follow the columns of G; never fails.
HWY_INLINE Mat3v gramSchmidt(const Mat3v& G) {
    const V one = set(1.f), zero = hn::Zero(d);
    const V first = dot(G.x, G.x), whole = squaredNorm(G);
    const V smallest = set(1e-10f) * whole + set(1e-30f);
    Vec3v x = G.x * (one / hn::Sqrt(first));
    const Mask noFirst = hn::Not(hn::Gt(first, smallest));
    if (HWY_UNLIKELY(any(noFirst))) x = select(noFirst, Vec3v{one, zero, zero}, x);
    const Vec3v rest = G.y - x * dot(x, G.y);
    const V second = dot(rest, rest);
    Vec3v y = rest * (one / hn::Sqrt(second));
    // The difference loses digits when the columns are nearly parallel: then once more.
    const Mask steep = hn::Not(hn::Gt(second, set(0.1f) * whole));
    if (HWY_UNLIKELY(any(steep))) {
        const Vec3v again = y - x * dot(x, y);
        y = select(steep, again * (one / hn::Sqrt(dot(again, again))), y);
        const Mask noSecond = hn::Not(hn::Gt(second, smallest));
        if (any(noSecond)) y = select(noSecond, perpendicular(x), y);
    }
    return {x, y, cross(x, y)};
}

/// Rotation by the vector w: exact rotation, angle 2·atan(|w|/2) (Cayley); no trigonometry.
HWY_INLINE Mat3v smallRotation(const Vec3v& w) {
    const V one = set(1.f);
    const Vec3v q = w * set(0.5f);
    const V s = set(2.f) / (one + dot(q, q));
    const Vec3v sq = q * s;
    const V xx = sq.x * q.x, yy = sq.y * q.y, zz = sq.z * q.z;
    const V xy = sq.x * q.y, yz = sq.y * q.z, zx = sq.z * q.x;
    return {{one - yy - zz, xy + sq.z, zx - sq.y},
            {xy - sq.z, one - zz - xx, yz + sq.x},
            {zx + sq.y, yz - sq.x, one - xx - yy}};
}

/// Newton's equation for a rotation of A by w: (tr(S)·I − S)·w = k, S and k the symmetric part and
/// the axial vector of A.
struct Turn {
    Vec3v k;
    Vec3v diagonal, off;  ///< inverse of tr(S)·I − S: xx yy zz; yz zx xy
    Mask safe;            ///< that matrix is well positive definite
    V trace;

    HWY_INLINE explicit Turn(const Mat3v& A) {
        k = {A.y.z - A.z.y, A.z.x - A.x.z, A.x.y - A.y.x};
        const V half = set(-0.5f);
        trace = A.x.x + A.y.y + A.z.z;
        const Vec3v m{A.y.y + A.z.z, A.z.z + A.x.x, A.x.x + A.y.y};
        const Vec3v o{half * (A.y.z + A.z.y), half * (A.z.x + A.x.z), half * (A.x.y + A.y.x)};
        const Vec3v cofactor{m.y * m.z - o.x * o.x, m.z * m.x - o.y * o.y, m.x * m.y - o.z * o.z};
        const Vec3v cofactorOff{o.y * o.z - m.x * o.x, o.z * o.x - m.y * o.y,
                                o.x * o.y - m.z * o.z};
        const V det = m.x * cofactor.x + o.z * cofactorOff.z + o.y * cofactorOff.y;
        safe = hn::And(hn::And(hn::Gt(m.x, hn::Zero(d)), hn::Gt(cofactor.z, hn::Zero(d))),
                       hn::Gt(det, set(0.02f) * trace * trace * trace));
        const V inverse = set(1.f) / det;
        diagonal = cofactor * inverse;
        off = cofactorOff * inverse;
    }
    HWY_INLINE Vec3v solve(const Vec3v& b) const {
        return {diagonal.x * b.x + off.z * b.y + off.y * b.z,
                off.z * b.x + diagonal.y * b.y + off.x * b.z,
                off.y * b.x + off.x * b.y + diagonal.z * b.z};
    }
};

/// |A − I|² below which an error of third order is one of rounding.
constexpr float kTiny2 = 1.6e-5f;

struct Polar {
    Mat3v R;
    V trace;  ///< of S = RᵀA
};

/// For the lanes in `todo`: the iteration of glsl/physics/polar.glsl, safe for any matrix (Newton
/// where that is safe; else the step of Müller et al. 2016). Takes copies: a matrix whose address
/// is given away would live in memory on the usual way, too.
HWY_NOINLINE Polar polarOfAny(Mat3v A, Mask todo, Polar others) {
    Mat3v R = gramSchmidt(A);
    Mask moving = todo;
    for (int i = 0; i < 12 && any(moving); ++i) {
        const Turn turn(transposeTimes(R, A));
        const Vec3v climb = turn.k * (set(1.f) / (hn::Abs(turn.trace) + set(1e-9f)));
        const Vec3v w = select(turn.safe, turn.solve(turn.k), climb);
        R = select(moving, R * smallRotation(w), R);
        moving = hn::AndNot(hn::Lt(dot(w, w), set(1e-14f)), moving);
    }
    const V trace = dot(R.x, A.x) + dot(R.y, A.y) + dot(R.z, A.z);
    return {select(todo, R, others.R), hn::IfThenElse(todo, trace, others.trace)};
}

/// Rotation of A near the identity.
///
/// The Cayley rotation by w makes RᵀA symmetric exactly where (tr(S)·I − S)·w = k − ¼(k·w)·w:
/// Newton's equation and a small term. So the matrix is inverted once and w found by fixed-point
/// iteration, each turn of which gains a factor of about ½|w|². The same algebra gives
/// tr(RᵀA) = tr(A) + ½k·w.
HWY_INLINE Polar polarOfNear(const Mat3v& A) {
    const Turn turn(A);
    const V quarter = set(0.25f);
    const Vec3v first = turn.solve(turn.k);
    Vec3v w = turn.solve(turn.k - first * (quarter * dot(turn.k, first)));
    const V size = dot(w, w);
    // Below 0.03 rad the second w is right to 1e-8 already.
    Mask easy = turn.safe;
    const Mask moving = hn::Not(hn::Lt(size, set(1e-3f)));
    if (HWY_UNLIKELY(any(moving))) {
        for (int i = 0; i < 6; ++i) {
            const Vec3v next = turn.solve(turn.k - w * (quarter * dot(turn.k, w)));
            w = select(moving, next, w);
        }
        easy = hn::And(easy, hn::Lt(size, set(0.1f)));
    }
    const Polar usual{smallRotation(w), turn.trace + set(0.5f) * dot(turn.k, w)};
    if (HWY_LIKELY(hn::AllTrue(d, easy))) return usual;
    return polarOfAny(A, hn::Not(easy), usual);
}

/// Rotation of A. Meant for A near the identity, as in a frame that turns along.
///
/// With A = I + e + half of [k]×, the equation of polarOfNear() is 2w = k − (tr(e)·I − e)·w −
/// ¼(k·w)·w. In stiff things e and k are tiny, and w = ½k put into its right side, the last term
/// left out, makes an error of third order: no matrix is inverted and nothing divided.
///
/// stiff: whether to try that.
HWY_INLINE Polar polarNearIdentity(const Mat3v& A, bool stiff) {
    if (!stiff) return polarOfNear(A);
    const V one = set(1.f), half = set(0.5f);
    const Vec3v k{A.y.z - A.z.y, A.z.x - A.x.z, A.x.y - A.y.x};
    const Vec3v e{A.x.x - one, A.y.y - one, A.z.z - one};
    const Vec3v o{half * (A.y.z + A.z.y), half * (A.z.x + A.x.z), half * (A.x.y + A.y.x)};
    const V size = dot(e, e) + set(2.f) * dot(o, o) + half * dot(k, k);  // |A − I|²
    const Mask tiny = hn::Lt(size, set(kTiny2));
    const Vec3v q = k * set(0.25f);  // ½w, nearly
    const Vec3v m{e.y + e.z, e.z + e.x, e.x + e.y};
    const Vec3v p{q.x - half * (m.x * q.x - o.z * q.y - o.y * q.z),
                  q.y - half * (m.y * q.y - o.z * q.x - o.x * q.z),
                  q.z - half * (m.z * q.z - o.y * q.x - o.x * q.y)};
    // smallRotation() of 2p, but for 1/(1 + p²).
    const Vec3v sp = p + p;
    const V xx = sp.x * p.x, yy = sp.y * p.y, zz = sp.z * p.z;
    const V xy = sp.x * p.y, yz = sp.y * p.z, zx = sp.z * p.x;
    const Polar usual{{{one - yy - zz, xy + sp.z, zx - sp.y},
                       {xy - sp.z, one - zz - xx, yz + sp.x},
                       {zx + sp.y, yz - sp.x, one - xx - yy}},
                      A.x.x + A.y.y + A.z.z + dot(k, p)};
    if (HWY_LIKELY(hn::AllTrue(d, tiny))) return usual;
    const Polar other = polarOfNear(A);
    return {select(tiny, usual.R, other.R), hn::IfThenElse(tiny, usual.trace, other.trace)};
}

}  // namespace sunder::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
