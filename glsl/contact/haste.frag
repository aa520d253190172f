// After a search, one fragment per cell: how much too fast what it met is, kept by MAX blending until somebody looks.
#include "gather/cell_texel.glsl"
#include "contact/left_out.glsl"

uniform sampler2DArray summaries;  // layer 0: contact/search.frag

layout(location = 0) out vec4 haste;  // x

void main() {
    float quarterOctaves = hasteOf(texelFetch(summaries, ivec3(gl_FragCoord.xy, 0), 0).z);
    if (quarterOctaves == 0.0) discard;
    haste = vec4(quarterOctaves, 0.0, 0.0, 0.0);
}
