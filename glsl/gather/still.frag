// Falling asleep: a node's record without its velocity, or a cell's bonds as they are, for the other half of the ping-pong.
uniform sampler2DArray records;  // two layers

layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    first = texelFetch(records, ivec3(texel, 0), 0);
#if NODES
    second = vec4(0.0);
#else
    second = texelFetch(records, ivec3(texel, 1), 0);
#endif
}
