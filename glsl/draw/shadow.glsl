// Sunlight that reaches a point: percentage-closer soft shadows (Fernando 2005) from the shadow map.

uniform sampler2DShadow shadowMap;  // compares with a depth
uniform sampler2D shadowDepth;      // the same texture, as it is
uniform sampler2D shadowVeil;       // of glass: share of light that passes; alpha: from what depth on it is missing
uniform mat4 shadowMatrix;          // world to the map's texture coordinates and depth, 0 to 1
uniform mat3 shadowNormals;         // the same for normals, any length
uniform vec2 shadowSize;            // m, across the map and along its depth

// Half the sun's width in the sky, as a tangent: four times the true one, so that a wall's shadow is visibly soft.
const float SUN_TANGENT = 0.018;
const float MOST_BLUR = 0.07;  // m, radius
const mat2 GOLDEN_TURN = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);  // cos and sin of π(3 − √5)

// Turns the samples' pattern from pixel to pixel, so that its gaps become grain: interleaved gradient noise (Jimenez 2014).
vec2 patternTurn() {
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    return vec2(cos(turn), sin(turn));
}

// 1 in the light, 0 in the shade. `normal` is the surface's, unit length; `cosine` is its cosine to the sun.
// Samples are compared with the depth of the surface's own plane where they lie, so that a wide kernel finds no acne and the
// point hardly has to leave its surface: shadows stay attached to what casts them.
float sunVisibility(vec3 p, vec3 normal, float cosine) {
    const int SEARCH_SAMPLES = 6, FILTER_SAMPLES = 12;
    float texel = shadowSize.x / float(textureSize(shadowDepth, 0).x);
    float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
    vec3 s = (shadowMatrix * vec4(p + normal * texel * (0.6 + 1.2 * sine), 1.0)).xyz;
    if (any(lessThan(s.xy, vec2(0.0))) || any(greaterThan(s.xy, vec2(1.0)))) return 1.0;
    s.z = min(s.z, 1.0);
    vec4 veil = textureLod(shadowVeil, s.xy, 0.0);
    float passes = s.z > veil.a + 0.02 / shadowSize.y ? veil.r : 1.0;
    vec3 plane = shadowNormals * normal;
    vec2 slope = -plane.xy / min(plane.z, -0.15 * length(plane.xy) * shadowSize.x / shadowSize.y - 1e-6);

    float search = MOST_BLUR / shadowSize.x;
    vec2 direction = patternTurn();
    float blockers = 0.0, depths = 0.0;
    for (int i = 0; i < SEARCH_SAMPLES; ++i, direction = GOLDEN_TURN * direction) {
        vec2 offset = search * sqrt(float(i) / float(SEARCH_SAMPLES)) * direction;
        float depth = textureLod(shadowDepth, s.xy + offset, 0.0).r;
        float blocks = step(depth, s.z + dot(slope, offset));
        blockers += blocks;
        depths += blocks * depth;
    }
    float distance = (s.z - depths / max(blockers, 1.0)) * shadowSize.y;
    float radius = clamp(SUN_TANGENT * distance, 1.5 * texel, MOST_BLUR) / shadowSize.x;
    // Where all samples agree, which is almost everywhere, there is nothing to filter. A loop that ends at once, not a branch:
    // Mesa's software driver computes both sides of a branch.
    int samples = blockers == 0.0 || blockers == float(SEARCH_SAMPLES) ? 0 : FILTER_SAMPLES;
    float lit = 0.0;
    for (int i = 0; i < samples; ++i, direction = GOLDEN_TURN * direction) {
        vec2 offset = radius * sqrt((float(i) + 0.5) / float(FILTER_SAMPLES)) * direction;
        lit += texture(shadowMap, vec3(s.xy + offset, s.z + dot(slope, offset)));
    }
    return passes * (samples == 0 ? 1.0 - step(1.0, blockers) : lit / float(samples));
}
