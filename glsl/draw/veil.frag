// What lets light through casts a light shadow (src/render/shadow_map.hpp): by multiplication the share of sunlight that passes,
// and in alpha by MIN blending the depth from where it is missing.
out vec4 veil;

void main() {
    const float PASSES = 0.8;
    veil = vec4(vec3(PASSES), gl_FragCoord.z);
}
