// Which instruction sets the kernels are compiled for: include before hwy/highway.h. Left out are
// sets that differ from their neighbours only in instructions the kernels do not use, and those
// whose vectors have no size at compile time (SVE, RISC-V), which cannot stand in a struct.
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif
