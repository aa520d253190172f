// Contact search, first pass: one fragment per cell. Where its sphere is, how it moves.
#include "gather/cell_texel.glsl"
#include "contact/sphere.glsl"

layout(location = 0) out vec4 centre;    // m; w: radius, m, 0 where no cell is
layout(location = 1) out vec4 velocity;  // m/s; w unused

void main() {
    int cell = fragmentIndex();
    centre = velocity = vec4(0.0);
    uvec4 record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return;
    BodyRecord body = bodyRecord(bodyOf(record));
    vec3 x, v;
    sphereOf(cell, body.cellSize.xyz, x, v);
    centre = vec4(x, body.events.w);
    velocity = vec4(v, 0.0);
}
