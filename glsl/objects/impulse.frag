// Blended, x by addition, w by MAX: what objects push a cell with.
#include "incidents/rank.glsl"

flat in float impulse;  // N·s
flat in int object_;
layout(location = 0) out vec4 pushed;

void main() { pushed = vec4(impulse, 0.0, 0.0, rankOf(impulse, kNobody - 1u - uint(object_))); }
