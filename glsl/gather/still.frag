// Falling asleep: what a body's cells hold, for the other half of the ping-pong. Nodes lose their velocities.
uniform sampler2DArray records;

#if NODES
layout(location = 0) out vec4 copied[8];  // four nodes from number FIRST on
#else
layout(location = 0) out vec4 copied[2];  // BondRecord
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
#if NODES
    for (int i = 0; i < 8; i += 2) {
        copied[i] = texelFetch(records, ivec3(texel, 2 * FIRST + i), 0);
        copied[i + 1] = vec4(0.0);
    }
#else
    copied[0] = texelFetch(records, ivec3(texel, 0), 0);
    copied[1] = texelFetch(records, ivec3(texel, 1), 0);
#endif
}
