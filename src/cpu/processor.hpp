#pragma once
#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

// What each kind of processor has an instruction of its own for.
namespace sunder::cpu {

/// A thread that spins lets the other one of its core work meanwhile.
inline void pauseProcessor() {
#if defined(__SSE2__) || defined(_M_X64)
    _mm_pause();
#elif defined(__aarch64__) && !defined(_MSC_VER)
    asm volatile("yield");
#endif
}

/// While it lives, this thread takes numbers below 1e-38 for zero. At the foot of every wave that
/// runs into material at rest stand some; arithmetic on them is up to a hundred times slower.
class FlushDenormals {
  public:
    FlushDenormals() : before_(control()) {
#if defined(__SSE2__) || defined(_M_X64)
        setControl(before_ | 0x8040);  // flush results to zero, take operands for zero
#elif defined(__aarch64__) && !defined(_MSC_VER)
        setControl(before_ | std::uint64_t{1} << 24);
#endif
    }
    ~FlushDenormals() {
        setControl(before_);
    }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

  private:
#if defined(__SSE2__) || defined(_M_X64)
    using Control = unsigned;
    static Control control() {
        return _mm_getcsr();
    }
    static void setControl(Control c) {
        _mm_setcsr(c);
    }
#elif defined(__aarch64__) && !defined(_MSC_VER)
    using Control = std::uint64_t;
    static Control control() {
        Control c;
        asm volatile("mrs %0, fpcr" : "=r"(c));
        return c;
    }
    static void setControl(Control c) {
        asm volatile("msr fpcr, %0" : : "r"(c));
    }
#else
    using Control = int;
    static Control control() {
        return 0;
    }
    static void setControl(Control) {}
#endif
    Control before_;
};

}  // namespace sunder::cpu
