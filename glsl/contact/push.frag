// Contact forces: one fragment per cell that has partners, added to the forces on its corners.
#include "gather/cell_texel.glsl"
#include "contact/spheres.glsl"

uniform sampler2DArray partners;  // contact/search.frag
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
    for (int k = 0; k < 8; ++k) forces[k] = vec4(0.0);
    int self = fragmentIndex();
    uvec4 record = cellRecord(self);
    BodyRecord body = bodyRecord(bodyOf(record));
    Cell own = cellAt(self, body.cellSize.xyz);
    Proxy ownProxy = proxyOf(body);
    ContactSide ownSide = sideOf(self, record, body);

    for (int p = 0; p < count; ++p) {
        int other = int(texelFetch(partners, ivec3(texel, 1 + (p >> 2)), 0)[p & 3]);
        uvec4 otherRecord = cellRecord(other);
        BodyRecord otherBody = bodyRecord(bodyOf(otherRecord));
        Cell theirs = cellAt(other, otherBody.cellSize.xyz);
        Proxy otherProxy = proxyOf(otherBody);
        ContactSide otherSide = sideOf(other, otherRecord, otherBody);
        ivec3 offset;
        bool neighbours = latticeNeighbours(self, other, record, otherRecord, offset);
        // Both cells of a pair work out the same numbers: the lower one's less the higher one's.
        float sign_ = self < other ? 1.0 : -1.0;
        for (int i = 0; i < sphereCount(ownProxy); ++i) {
            vec3 place = spherePlace(ownProxy, i), x, v;
            sphereOf(own, place, x, v);
            vec3 force = vec3(0.0);
            for (int j = 0; j < sphereCount(otherProxy); ++j) {
                vec3 y, w;
                sphereOf(theirs, spherePlace(otherProxy, j), y, w);
                force += sign_ * contactForce(ownSide, otherSide, sign_ * (x - y), sign_ * (v - w), neighbours, stepSize);
            }
            for (int k = 0; k < 8; ++k) forces[k].xyz += cornerWeight(k, place) * force;
        }
    }
}
