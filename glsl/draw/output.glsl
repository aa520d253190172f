// Where a fragment's colour goes. Opaque: through the tone curve into the picture. TRANSPARENT: into the two sums of
// weighted blended order-independent transparency (McGuire and Bavoil 2013), which draw/transparent.frag puts over the picture.
#include "draw/tone.glsl"

#ifdef TRANSPARENT
layout(location = 0) out vec4 lightSum;     // Σ w·(light, opacity)
layout(location = 1) out vec4 transmission; // Π (1 − opacity), by blending
#else
out vec4 colour;
#endif

// `shaded`: what shade() returned. `range`: m, from the eye. `toned`: it is light, and the tone curve makes a colour of it.
void writeColour(vec4 shaded, float range, bool toned) {
#ifdef TRANSPARENT
    // Light falls off with the layers in front. Half floats hold this for any range.
    float weight = clamp(100.0 / (1.0 + range * range * range), 1e-2, 100.0);
    lightSum = weight * min(shaded, vec4(50.0));
    transmission = vec4(shaded.a);
#else
    colour = vec4(toned ? toneCurve(shaded.rgb) : shaded.rgb, 1.0);
#endif
}

void writeColour(vec4 shaded, float range) {
    writeColour(shaded, range, true);
}
