#include "draw/light.glsl"
#include "draw/output.glsl"

uniform vec3 eye;

in vec3 position;
in vec3 normal;
in vec3 direction;
flat in float seams;
flat in vec3 baseColour;

// Two crossing bands, 0 to 1: where they are shows how a round object is turned.
float band() {
    vec2 across = abs(direction.xz);
    vec2 w = fwidth(direction.xz) + 1e-4;
    const float HALF_WIDTH = 0.09;
    vec2 inside = 1.0 - smoothstep(HALF_WIDTH - w, HALF_WIDTH + w, across);
    return seams * max(inside.x, inside.y);
}

void main() {
    vec3 n = normalize(normal);
    vec3 view = normalize(eye - position);
    Reflector iron = Reflector(baseColour * (1.0 - 0.45 * band()), 0.42, 0.10, 1.0);
    // Where it is dark there is less to mirror.
    vec3 ambient = ambientAt(position.y, n);
    vec3 way = reflect(-view, n);
    vec3 mirrored = mix(mirroredAt(way), skyLight(way), 0.4) * min(2.5 * ambient.g, 1.0);
    writeColour(vec4(reflected(iron, position, n, n, view, mirrored), 1.0), distance(eye, position));
}
