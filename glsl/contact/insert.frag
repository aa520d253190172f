#include "contact/grid.glsl"

flat in int number;
flat in int eighth;

layout(location = 0) out vec4 largest[2];   // blended by MAX
layout(location = 2) out vec4 smallest[2];  // by MIN
layout(location = 4) out vec4 count[2];     // by addition

void main() {
    vec4 own = vec4(equal(ivec4(0, 1, 2, 3), ivec4(eighth & 3)));
    for (int half_ = 0; half_ < 2; ++half_) {
        vec4 here = half_ == eighth >> 2 ? own : vec4(0.0);
        largest[half_] = here * float(number);
        smallest[half_] = mix(vec4(kNobody), vec4(float(number)), greaterThan(here, vec4(0.0)));
        count[half_] = here;
    }
}
