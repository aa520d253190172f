// What a search for contacts leaves out, as one number: how many it had no room for, less than kHasteUnit, and how many times as fast
// as it can follow things met, in quarter octaves: 0, as fast at most.
#include "shared/constants.h"

float leftOut(float dropped, float haste) { return min(dropped, float(kHasteUnit - 1)) + float(kHasteUnit) * haste; }
float droppedOf(float number) { return mod(number, float(kHasteUnit)); }
float hasteOf(float number) { return floor(number / float(kHasteUnit)); }
