// Puts the sums that draw/output.glsl describes over the picture, sample by sample: light added to what is let through.
#include "draw/tone.glsl"

uniform sampler2DMS lightSum;
uniform sampler2DMS transmission;

out vec4 colour;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float through = texelFetch(transmission, at, gl_SampleID).r;
    if (through == 1.0) discard;
    vec4 sum = texelFetch(lightSum, at, gl_SampleID);
    vec3 light = sum.rgb / max(sum.a, 1e-5) * (1.0 - through);
    colour = vec4(toneCurve(light), through);
}
