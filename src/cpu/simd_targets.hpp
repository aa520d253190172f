// Which instruction sets the kernels are compiled for: include before hwy/highway.h. Left out are
// sets that differ from their neighbours only in instructions the kernels do not use, and those
// whose vectors have no size at compile time (SVE, RISC-V), which cannot stand in a struct.
#include <hwy/base.h>
#ifndef HWY_DISABLED_TARGETS
#if HWY_MAJOR > 1 || HWY_MINOR > 0
#define SUNDER_LATER_SETS (HWY_AVX3_ZEN4 | HWY_AVX3_SPR)  // not in Highway 1.0
#else
#define SUNDER_LATER_SETS 0
#endif
#define HWY_DISABLED_TARGETS                                                          \
    (HWY_SSSE3 | HWY_AVX3_DL | SUNDER_LATER_SETS | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
     HWY_SVE2_128 | HWY_RVV)
#endif

// Every 64-bit ARM has NEON, so there is one set and nothing to choose while the program runs.
// Highway would choose all the same, between sets that differ in cryptography, by pragmas. The
// implicit constructors of the kernels' structs do not get those, and no vector's operation could
// be inlined into them.
#if defined(__aarch64__) || defined(_M_ARM64)
#define TOOLCHAIN_MISS_SYS_AUXV_H    // as Highway 1.0 is told
#define HWY_HAVE_RUNTIME_DISPATCH 0  // as later ones are
#endif
