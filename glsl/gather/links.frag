// After bonds broke: joints of each cell, one fragment (or invocation) per cell (LinkRecord, a target for each of its parts).
#include "gather/cell_texel.glsl"
#include "physics/joints.glsl"

uniform sampler2DArray bonds;  // layers of BondRecord

#ifndef COMPUTE
layout(location = 0) out vec4 newMasks;
layout(location = 1) out vec4 newInverseMassLow;
layout(location = 2) out vec4 newInverseMassHigh;
#endif

uint heldBy(int cell, ivec3 offset) { return heldWith(texelFetch(bonds, ivec3(texelAddress(cell), 0), 0).xyz); }

#ifdef COMPUTE
void main() {
    int cell = invocationCell();
    if (cell < 0) return;
    ivec2 texel = texelAddress(cell);
    LinkRecord links = joints(cell);
    imageStore(target, ivec3(texel, 0), links.masks);
    imageStore(target, ivec3(texel, 1), links.inverseMassLow);
    imageStore(target, ivec3(texel, 2), links.inverseMassHigh);
}
#else
void main() {
    LinkRecord links = joints(fragmentIndex());
    newMasks = links.masks;
    newInverseMassLow = links.inverseMassLow;
    newInverseMassHigh = links.inverseMassHigh;
}
#endif
