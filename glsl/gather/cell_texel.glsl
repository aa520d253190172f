// Fragments as cells or nodes: the texel a fragment fills is the number of what it computes.
#include "shared/layout.h"

uniform int cellCount;

int fragmentIndex() { return int(gl_FragCoord.y) * SUNDER_TEXTURE_WIDTH + int(gl_FragCoord.x); }
