#include "draw/light.glsl"

uniform vec3 eye;

in vec3 position;
in vec3 normal;
in vec3 direction;
flat in float seams;
flat in vec3 baseColour;

out vec4 colour;

// Two crossing bands, 0 to 1: where they are shows how a round object is turned.
float band() {
    vec2 across = abs(direction.xz);
    vec2 w = fwidth(direction.xz) + 1e-4;
    const float HALF_WIDTH = 0.09;
    vec2 inside = 1.0 - smoothstep(HALF_WIDTH - w, HALF_WIDTH + w, across);
    return seams * max(inside.x, inside.y);
}

// What smooth iron mirrors of its surroundings.
vec3 mirrored(vec3 d) {
    return mix(GROUND_LIGHT, skyColour(d), smoothstep(-0.15, 0.15, d.y));
}

void main() {
    vec3 n = normalize(normal);
    vec3 view = normalize(position - eye);
    vec3 light = lightAt(position, n);
    float gloss = 0.04 + 0.30 * pow(clamp(1.0 + dot(view, n), 0.0, 1.0), 5.0);
    // Where it is dark there is less to mirror.
    vec3 gleam = gloss * mirrored(reflect(view, n)) * min(light.g, 1.0);
    colour = vec4(baseColour * (1.0 - 0.45 * band()) * light + gleam, 1.0);
}
