// Contact search, first pass: one fragment per cell. Its centre, how far its spheres reach, its velocity.
#include "gather/cell_texel.glsl"
#include "contact/spheres.glsl"

layout(location = 0) out vec4 centre;
layout(location = 1) out vec4 velocity;

void main() {
    int cell = fragmentIndex();
    centre = velocity = vec4(0.0);
    uvec4 record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return;
    BodyRecord body = bodyRecord(bodyOf(record));
    Cell own = cellAt(cell, body.cellSize.xyz);
    Proxy proxy = proxyOf(body);
    vec3 x, v;
    sphereOf(own, vec3(0.5), x, v);
    float reach = 0.0;
    if (sphereCount(proxy) > 1) {
        for (int s = 0; s < sphereCount(proxy); ++s) {
            vec3 p, q;
            sphereOf(own, spherePlace(proxy, s), p, q);
            reach = max(reach, distance(p, x));
        }
    }
    centre = vec4(x, reach + proxy.radius);
    velocity = vec4(v, proxy.radius);
}
