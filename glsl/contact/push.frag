// Contact forces: one fragment per cell that has partners, added to the forces on its corners.
#include "gather/cell_texel.glsl"
#include "contact/sphere.glsl"

uniform sampler2DArray partners;  // contact/search.frag
uniform samplerBuffer strengths;  // w: friction
uniform float stepSize;           // s

layout(location = 0) out vec4 forces[8];  // N, blended by addition

ContactSide sideOf(int cell, uvec4 record, BodyRecord body) {
    return ContactSide(8.0 * cornerMass(record), uintBitsToFloat(record.w), texelFetch(strengths, cell).w, body.events.w,
                       texelFetch(partners, ivec3(texelAddress(cell), 0), 0).y);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int count = int(texelFetch(partners, ivec3(texel, 0), 0).x);
    if (count == 0) discard;
    int self = fragmentIndex();
    uvec4 record = cellRecord(self);
    BodyRecord body = bodyRecord(bodyOf(record));
    ContactSide ownSide = sideOf(self, record, body);
    vec3 x, v, sum = vec3(0.0);
    sphereOf(self, body.cellSize.xyz, x, v);

    for (int p = 0; p < count; ++p) {
        int other = int(texelFetch(partners, ivec3(texel, 1 + (p >> 2)), 0)[p & 3]);
        uvec4 otherRecord = cellRecord(other);
        BodyRecord otherBody = bodyRecord(bodyOf(otherRecord));
        vec3 y, w;
        sphereOf(other, otherBody.cellSize.xyz, y, w);
        // Both cells of a pair work out the same numbers: the lower one's less the higher one's.
        float sign_ = self < other ? 1.0 : -1.0;
        sum += sign_ * contactForce(ownSide, sideOf(other, otherRecord, otherBody), sign_ * (x - y), sign_ * (v - w),
                                    latticeNeighbours(self, other, record, otherRecord), stepSize);
    }
    for (int k = 0; k < 8; ++k) forces[k] = vec4(0.125 * sum, 0.0);
}
