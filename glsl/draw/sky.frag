#include "draw/output.glsl"
#include "draw/sky.glsl"
#include "draw/surface_layers.glsl"

in vec3 direction;

// Share of the sky that clouds cover in the unit direction d: a flat layer of them, lost in the haze towards the horizon.
float cloudCover(vec3 d) {
    vec2 above = d.xz / max(d.y + 0.06, 0.02);
    float density = texture(surfaces, vec3(0.11 * above, surfaceLayers[SUNDER_LAYER_CLOUDS])).r;
    return smoothstep(0.5, 0.85, density) * smoothstep(0.03, 0.22, d.y);
}

void main() {
    vec3 d = normalize(direction);
    vec3 white = vec3(0.80, 0.82, 0.85) + vec3(0.30, 0.24, 0.16) * pow(max(dot(d, SUN_DIRECTION), 0.0), 4.0);
    writeColour(vec4(mix(skyColour(d), white, 0.75 * cloudCover(d)), 1.0), 1.0);
}
