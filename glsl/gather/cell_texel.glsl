// Fragments as cells or nodes: the texel a fragment fills is the number of what it computes.
#include "physics/lattice.glsl"

int fragmentIndex() { return (int(gl_FragCoord.y) << textureShift) + int(gl_FragCoord.x); }
