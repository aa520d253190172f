// After bonds broke: joints of each cell, one fragment per cell (LinkRecord, a target for each of its parts).
#include "gather/cell_texel.glsl"
#include "physics/joints.glsl"

uniform sampler2DArray bonds;  // layers of BondRecord

layout(location = 0) out vec4 newMasks;
layout(location = 1) out vec4 newInverseMassLow;
layout(location = 2) out vec4 newInverseMassHigh;

vec3 damageOf(int cell) { return texelFetch(bonds, ivec3(texelAddress(cell), 0), 0).xyz; }

void main() {
    LinkRecord links = joints(fragmentIndex());
    newMasks = links.masks;
    newInverseMassLow = links.inverseMassLow;
    newInverseMassHigh = links.inverseMassHigh;
}
