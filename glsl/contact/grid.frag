#include "contact/grid.glsl"

flat in int number;
flat in int eighths;

// Blended by MAX, their alphas by addition.
layout(location = 0) out vec4 extremes;
layout(location = 1) out vec4 inEighths;
layout(location = 2) out vec4 inOtherOrders;

void main() {
    float own = float(number);
    vec3 other = scrambled(own);
    vec2 halves = numberHalves(own);
    extremes = vec4(own, kNumbers - own, other.x, 1.0);
    inEighths = vec4(vec3(equal(ivec3(0, 1, 2), ivec3(eighths))) * own, halves.x);
    inOtherOrders = vec4(other.y, kNumbers - other.y, other.z, halves.y);
}
