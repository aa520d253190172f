// Rest check, once a frame: one fragment per chunk of a body's cells. What its nodes and bonds did since the last one.
#include "gather/cell_texel.glsl"
#include "gather/node.glsl"

uniform usamplerBuffer chunks;  // first cell, number of cells
uniform sampler2DArray bonds;   // layer 0, w: 1 where damage grew

#if CONTACT
#include "contact/left_out.glsl"
uniform sampler2DArray summaries;  // layer 0: contact/search.frag
uniform sampler2DArray hastes;     // contact/haste.frag
uniform samplerBuffer rest;        // xyz: rest position, m
#endif

// Largest squared speed, m²/s²; 1 where damage grew; the largest of what its cells touch; contacts there was no room for, and
// 16384 times how much too fast things met (contact/left_out.glsl).
layout(location = 0) out vec4 unrest;
#if CONTACT
// xyz: the box around its nodes, m; w unused. Where all its cells are absent, low is above high.
layout(location = 1) out vec4 lowest;
layout(location = 2) out vec4 highest;
#endif

void main() {
    uvec2 chunk = texelFetch(chunks, fragmentIndex()).xy;
    int first = int(chunk.x), end = first + int(chunk.y);
    float speed = 0.0, damage = 0.0, touched = 0.0, dropped = 0.0, haste = 0.0;
#if CONTACT
    vec3 low = vec3(1.0e30), high = vec3(-1.0e30);
#endif
    for (int cell = first; cell < end; ++cell) {
        ivec2 texel = texelAddress(cell);
        for (int corner = 0; corner < 8; ++corner)
            speed = max(speed, texelFetch(nodes, ivec3(texel, velocityLayer(corner)), 0).w);
        damage = max(damage, texelFetch(bonds, ivec3(texel, 0), 0).w);
#if CONTACT
        vec4 summary = texelFetch(summaries, ivec3(texel, 0), 0);
        touched = max(touched, summary.w);
        dropped += droppedOf(summary.z);
        haste = max(haste, texelFetch(hastes, ivec3(texel, 0), 0).x);
        if (lawOf(cellRecord(cell)) == SUNDER_ABSENT) continue;
        for (int corner = 0; corner < 8; ++corner) {
            vec3 place = texelFetch(rest, 8 * cell + corner).xyz +
                         texelFetch(nodes, ivec3(texel, displacementLayer(corner)), 0).xyz;
            low = min(low, place);
            high = max(high, place);
        }
#endif
    }
    unrest = vec4(speed, damage, touched, dropped + 16384.0 * haste);
#if CONTACT
    lowest = vec4(low, 0.0);
    highest = vec4(high, 0.0);
#endif
}
