// Sunlight that reaches a point, from the shadow map.

uniform sampler2DShadow shadowMap;
uniform mat4 shadowMatrix;  // world to the map's texture coordinates and depth, 0 to 1
uniform float shadowTexel;  // m, one texel of the map on a plane that faces the sun

// 1 in the light, 0 in the shade. `normal` is the surface's, unit length; `cosine` is its cosine to the sun.
// The point is moved off its surface by what the filter can reach below it on a slope: enough against acne, and at a few
// texels too little to detach a shadow from what casts it.
float sunVisibility(vec3 p, vec3 normal, float cosine) {
    float sine = sqrt(max(0.0, 1.0 - cosine * cosine));
    p += normal * shadowTexel * (0.7 + 2.6 * sine);
    vec3 s = (shadowMatrix * vec4(p, 1.0)).xyz;
    if (any(lessThan(s.xy, vec2(0.0))) || any(greaterThan(s.xy, vec2(1.0)))) return 1.0;
    s.z = min(s.z, 1.0);
    vec2 texel = 1.0 / vec2(textureSize(shadowMap, 0));
    float lit = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            lit += texture(shadowMap, vec3(s.xy + 1.25 * vec2(x, y) * texel, s.z));
    return lit / 9.0;
}
