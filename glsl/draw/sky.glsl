// Light of the outdoor scene, in linear RGB. Shared by everything that fades into the sky or is lit by it.
#include "draw/sun.h"

const vec3 SUN_DIRECTION = normalize(SUNDER_SUN_DIRECTION);
// What a white surface that faces the sun throws back of it.
const vec3 SUN_LIGHT = vec3(1.75, 1.53, 1.22);

// Colour of the sky in the unit direction d. Below the horizon it is the haze, slowly darker: what a scene without a floor
// stands in front of.
vec3 skyColour(vec3 d) {
    const vec3 ZENITH = vec3(0.18, 0.31, 0.54);
    const vec3 MIDDLE = vec3(0.33, 0.49, 0.72);
    const vec3 HAZE = vec3(0.64, 0.73, 0.82);
    float up = max(d.y, 0.0);
    vec3 c = mix(HAZE, MIDDLE, 1.0 - exp(-8.0 * up));
    c = mix(c, ZENITH, smoothstep(0.05, 0.9, up));
    float sun = max(dot(d, SUN_DIRECTION), 0.0);
    float sideways = 0.5 + 0.5 * dot(normalize(d.xz + vec2(1e-5, 0.0)), normalize(SUN_DIRECTION.xz));
    c += vec3(0.10, 0.07, 0.03) * sideways * exp(-5.0 * up);
    c += vec3(0.55, 0.42, 0.24) * (0.35 * pow(sun, 8.0) + pow(sun, 160.0));
    return c * mix(1.0, 0.55, smoothstep(0.0, 0.9, -d.y));
}

// What a white surface with the unit normal n throws back of the sky above it and the ground below: skyColour() with
// a few clouds, averaged over the hemisphere with the cosine as weight, fitted to normals that point up, towards the sun's side,
// away from it, and down.
const vec3 GROUND_LIGHT = vec3(0.25, 0.225, 0.19);
vec3 skyLight(vec3 n) {
    const vec3 UP = vec3(0.361, 0.469, 0.649), SIDEWAYS = vec3(0.216, 0.271, 0.354), SUNWARDS = vec3(0.023, 0.017, 0.010);
    vec3 sky = SIDEWAYS + SUNWARDS * dot(n.xz, normalize(SUN_DIRECTION.xz)) + n.y * (0.5 * UP + n.y * (0.5 * UP - SIDEWAYS));
    return sky + GROUND_LIGHT * (0.5 - 0.5 * n.y);
}

// What something smooth mirrors of its surroundings in the unit direction d.
vec3 mirroredAt(vec3 d) {
    return mix(GROUND_LIGHT, skyColour(d), smoothstep(-0.15, 0.15, d.y));
}
