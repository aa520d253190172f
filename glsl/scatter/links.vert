// After bonds broke: joints of each cell, one vertex per cell, written by transform feedback (LinkRecord).
#include "physics/joints.glsl"

uniform samplerBuffer bonds;  // BondRecord

out vec4 newMasks;
out vec4 newInverseMassLow;
out vec4 newInverseMassHigh;

uint heldBy(int cell, ivec3 offset) { return heldWith(texelFetch(bonds, 2 * cell).xyz); }

void main() {
    LinkRecord links = joints(gl_VertexID);
    newMasks = links.masks;
    newInverseMassLow = links.inverseMassLow;
    newInverseMassHigh = links.inverseMassHigh;
}
