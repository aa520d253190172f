// Vectors and matrices of SIMD vectors: one cell per lane. Compiled once per instruction set.
#if defined(SUNDER_CPU_SIMD_MATRIX_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SUNDER_CPU_SIMD_MATRIX_INL
#undef SUNDER_CPU_SIMD_MATRIX_INL
#else
#define SUNDER_CPU_SIMD_MATRIX_INL
#endif

#include <hwy/highway.h>

#include "cpu/cpu_body.hpp"

HWY_BEFORE_NAMESPACE();
namespace sunder::cpu::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kLanes>;
using V = hn::Vec<D>;
using Mask = hn::Mask<D>;
inline constexpr D d;
inline constexpr int kWidth = static_cast<int>(hn::MaxLanes(d));

struct Vec3v {
    V x, y, z;
};
/// Columns.
struct Mat3v {
    Vec3v x, y, z;
};

HWY_INLINE V set(float value) {
    return hn::Set(d, value);
}
HWY_INLINE Vec3v operator+(const Vec3v& a, const Vec3v& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE Vec3v operator-(const Vec3v& a, const Vec3v& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE Vec3v operator*(const Vec3v& a, V s) {
    return {a.x * s, a.y * s, a.z * s};
}
HWY_INLINE V dot(const Vec3v& a, const Vec3v& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Vec3v cross(const Vec3v& a, const Vec3v& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
HWY_INLINE Vec3v select(Mask m, const Vec3v& yes, const Vec3v& no) {
    return {hn::IfThenElse(m, yes.x, no.x), hn::IfThenElse(m, yes.y, no.y),
            hn::IfThenElse(m, yes.z, no.z)};
}
HWY_INLINE Mat3v select(Mask m, const Mat3v& yes, const Mat3v& no) {
    return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}
HWY_INLINE Vec3v operator*(const Mat3v& m, const Vec3v& v) {
    return m.x * v.x + m.y * v.y + m.z * v.z;
}
/// mᵀ·v
HWY_INLINE Vec3v transposeTimes(const Mat3v& m, const Vec3v& v) {
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
HWY_INLINE Mat3v transposeTimes(const Mat3v& a, const Mat3v& b) {
    return {transposeTimes(a, b.x), transposeTimes(a, b.y), transposeTimes(a, b.z)};
}
HWY_INLINE Mat3v operator*(const Mat3v& a, const Mat3v& b) {
    return {a * b.x, a * b.y, a * b.z};
}
HWY_INLINE Mat3v operator+(const Mat3v& a, const Mat3v& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE V determinant(const Mat3v& m) {
    return dot(m.x, cross(m.y, m.z));
}
HWY_INLINE V squaredNorm(const Mat3v& m) {
    return dot(m.x, m.x) + dot(m.y, m.y) + dot(m.z, m.z);
}

HWY_INLINE bool any(Mask m) {
    return !hn::AllFalse(d, m);
}
/// Three components of one corner; `array` points at this vector's cells in the corner's x.
HWY_INLINE Vec3v load3(const float* array, std::ptrdiff_t stride) {
    return {hn::Load(d, array), hn::Load(d, array + stride), hn::Load(d, array + 2 * stride)};
}
HWY_INLINE void store3(const Vec3v& v, float* array, std::ptrdiff_t stride) {
    hn::Store(v.x, d, array);
    hn::Store(v.y, d, array + stride);
    hn::Store(v.z, d, array + 2 * stride);
}

/// A constant of the cells' laws: the same in all lanes, or looked up.
struct LawLookup {
    const BodyArrays* body;
    int cell;
    HWY_INLINE V operator()(float Law::*field) const {
        if (body->kind != LawKind::Mixed) return set(body->law.*field);
        const hn::RebindToSigned<D> di;
        constexpr int words = sizeof(Law) / sizeof(float);
        const auto first = hn::Load(di, body->lawIndex + cell);
        return hn::GatherIndex(d, &(body->laws->*field),
                               hn::Mul(first, hn::Set(di, std::int32_t{words})));
    }
};

}  // namespace sunder::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
