// Rest check, once a frame: one fragment per chunk of a body's cells. What its nodes and bonds did since the last one.
#include "gather/cell_texel.glsl"
#include "gather/node.glsl"

uniform usamplerBuffer chunks;  // first cell, number of cells
uniform sampler2DArray bonds;   // layer 0, w: 1 where damage grew

#if CONTACT
uniform sampler2DArray summaries;  // layer 0: contact/search.frag
#endif

// Largest squared speed, m²/s²; 1 where damage grew; the largest of what its cells touch; contacts there was no room for.
layout(location = 0) out vec4 unrest;

void main() {
    uvec2 chunk = texelFetch(chunks, fragmentIndex()).xy;
    int first = int(chunk.x), end = first + int(chunk.y);
    float speed = 0.0, damage = 0.0, touched = 0.0, dropped = 0.0;
    for (int cell = first; cell < end; ++cell) {
        ivec2 texel = texelAddress(cell);
        for (int corner = 0; corner < 8; ++corner)
            speed = max(speed, texelFetch(nodes, ivec3(texel, velocityLayer(corner)), 0).w);
        damage = max(damage, texelFetch(bonds, ivec3(texel, 0), 0).w);
#if CONTACT
        vec4 summary = texelFetch(summaries, ivec3(texel, 0), 0);
        touched = max(touched, summary.w);
        dropped += summary.z;
#endif
    }
    unrest = vec4(speed, damage, touched, dropped);
}
