// Light of the outdoor scene, in linear RGB. Shared by everything that fades into the sky or is lit by it.
#include "draw/sun.h"

const vec3 SUN_DIRECTION = normalize(SUNDER_SUN_DIRECTION);
const vec3 SUN_LIGHT = vec3(1.22, 1.10, 0.92);
const vec3 SKY_LIGHT = vec3(0.33, 0.37, 0.43);
const vec3 GROUND_LIGHT = vec3(0.17, 0.155, 0.135);

// Colour of the sky in the unit direction d. Below the horizon it is the haze, slowly darker: what a scene without a floor
// stands in front of.
vec3 skyColour(vec3 d) {
    const vec3 ZENITH = vec3(0.12, 0.26, 0.52);
    const vec3 MIDDLE = vec3(0.29, 0.45, 0.69);
    const vec3 HAZE = vec3(0.57, 0.66, 0.75);
    float up = max(d.y, 0.0);
    vec3 c = mix(HAZE, MIDDLE, 1.0 - exp(-6.0 * up));
    c = mix(c, ZENITH, smoothstep(0.05, 0.9, up));
    float sun = max(dot(d, SUN_DIRECTION), 0.0);
    float sideways = 0.5 + 0.5 * dot(normalize(d.xz + vec2(1e-5, 0.0)), normalize(SUN_DIRECTION.xz));
    c += vec3(0.10, 0.07, 0.03) * sideways * exp(-5.0 * up);
    c += vec3(0.55, 0.42, 0.24) * (0.35 * pow(sun, 8.0) + pow(sun, 160.0));
    return c * mix(1.0, 0.55, smoothstep(0.0, 0.9, -d.y));
}
