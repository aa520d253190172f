// Light that falls on a surface outdoors: sun, sky, and what the ground throws back.
#include "draw/sky.glsl"
#include "draw/shadow.glsl"

uniform bool grounded;  // a floor at y = 0

// At p, on a surface with the unit normal n.
vec3 lightAt(vec3 p, vec3 n) {
    float cosine = dot(n, SUN_DIRECTION);
    float sun = cosine > 0.0 ? cosine * sunVisibility(p, n, cosine) : 0.0;
    vec3 ambient = mix(GROUND_LIGHT, SKY_LIGHT, 0.5 + 0.5 * n.y);
    // Close to the floor half of the sky is hidden: that things stand on it shows even in the shade.
    if (grounded) ambient *= 1.0 - 0.5 * exp(-8.0 * max(p.y, 0.0));
    return SUN_LIGHT * sun + ambient;
}
