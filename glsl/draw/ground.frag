#include "draw/output.glsl"
#include "draw/shadow.glsl"
#include "draw/sky.glsl"
#include "draw/surface_layers.glsl"

uniform vec3 eye;
uniform float tile;       // m
uniform float hazeLength;  // m, where two thirds of the ground are haze
uniform bool shadowed;
uniform vec4 room;  // m, low x and z, high x and z of its walls; 0: none

in vec3 position;

// Checkerboard of squares of side 1, averaged over a pixel's footprint w (the product of the two axes' box-filtered square
// waves): -1 to 1, and 0 where a pixel holds many squares.
float filteredChecker(vec2 p, vec2 w) {
    vec2 wave = 2.0 * (abs(fract((p - 0.5 * w) * 0.5) - 0.5) - abs(fract((p + 0.5 * w) * 0.5) - 0.5)) / w;
    return wave.x * wave.y;
}

// Coverage, 0 to 1, of a line where the room's walls stand, two centimetres wide or as wide as a pixel.
float roomLine(vec2 p) {
    if (room == vec4(0.0)) return 0.0;
    vec2 outside = max(room.xy - p, p - room.zw);  // negative inside
    return 1.0 - smoothstep(0.01, 0.01 + fwidth(p.x) + fwidth(p.y), abs(max(outside.x, outside.y)));
}

// Brightness of cast concrete at p (m), 1 on average.
float concrete(vec2 p) {
    float fine = texture(surfaces, vec3(p / layerSize(SUNDER_LAYER_CONCRETE), surfaceLayers[SUNDER_LAYER_CONCRETE])).r;
    return 2.0 * fine * mix(1.0, wideVariation(p, dFdx(p), dFdy(p)), 0.22);
}

// Coverage, 0 to 1, of the joints between tiles, a centimetre wide or less.
float tileJoint(vec2 p, vec2 w) {
    vec2 distance = abs(fract(p + 0.5) - 0.5), width = w + 0.012;
    vec2 line = clamp(1.0 - distance / width, 0.0, 1.0) * 0.012 / width;
    return max(line.x, line.y);
}

void main() {
    vec2 p = position.xz / tile;
    vec2 w = fwidth(p) + 1e-4;
    vec3 toEye = eye - position;
    float range = length(toEye);
    vec3 view = toEye / range;

    float near = 1.0 - smoothstep(0.35, 1.1, max(w.x, w.y));
    float checker = filteredChecker(p, w) * near;
    vec3 albedo = vec3(0.19, 0.185, 0.172) * concrete(position.xz) * (1.0 + 0.10 * checker) * (1.0 - 0.45 * near * tileJoint(p, w));
    albedo *= 1.0 - 0.7 * roomLine(position.xz);

    vec3 normal = vec3(0.0, 1.0, 0.0);
    float sun = SUN_DIRECTION.y;
    if (shadowed) sun *= sunVisibility(position, normal, SUN_DIRECTION.y);
    vec3 light = albedo * (SUN_LIGHT * sun + skyLight(normal));

    float haze = 1.0 - exp(-pow(range / hazeLength, 2.0));
    vec3 horizon = skyColour(normalize(vec3(-view.x, 0.0, -view.z)));
    writeColour(vec4(mix(light, horizon, haze), 1.0), range);
}
