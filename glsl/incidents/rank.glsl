// Who pushed hardest, as one number for MAX blending: it grows with the impulse (N·s) in half octaves, and its last 24 bits say who,
// a cell or, counted down from kNobody, an object.
#include "shared/constants.h"

float rankOf(float impulse, uint partner) {
    int halfOctave = int(floatBitsToUint(impulse) >> 22u) - 190;  // 64 for 1 N·s
    return uintBitsToFloat(uint(clamp(halfOctave, 1, 126)) << 24u | partner);
}

uint partnerOf(float rank) { return floatBitsToUint(rank) & kNobody; }
