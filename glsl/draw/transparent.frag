// Puts the sums that draw/output.glsl describes over the picture, sample by sample where it has several: light added to what is let through.
#include "draw/tone.glsl"

#if SAMPLES
uniform sampler2DMS lightSum;
uniform sampler2DMS transmission;
#define sampleOf(map, at) texelFetch(map, at, gl_SampleID)
#else
uniform sampler2D lightSum;
uniform sampler2D transmission;
#define sampleOf(map, at) texelFetch(map, at, 0)
#endif

out vec4 colour;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float through = sampleOf(transmission, at).r;
    if (through == 1.0) discard;
    vec4 sum = sampleOf(lightSum, at);
    vec3 light = sum.rgb / max(sum.a, 1e-5) * (1.0 - through);
    colour = vec4(toneCurve(light), through);
}
