// Contact search, third pass: one fragment per cell. Which cells it may touch until the next search (src/core/contact.hpp).
#include "gather/cell_texel.glsl"
#include "contact/spheres.glsl"
#include "contact/grid.glsl"
#include "physics/links.glsl"

uniform sampler2DArray grid;   // contact/grid.glsl
uniform sampler2DArray links;  // layers of LinkRecord
uniform float stepSize;        // s
uniform float searchInterval;  // s, until the next one

layout(location = 0) out vec4 partnersLow;   // numbers of cells, plus one; 0: none
layout(location = 1) out vec4 partnersHigh;
layout(location = 2) out vec4 summary;       // partners; N; how many there was no room for; another body it touches, plus one

const float kSleepSpeed = 0.06;  // cell edges/s, src/core/sleep.hpp

int self;
uvec4 record;
vec4 centre, velocity;
BodyRecord body;
vec4 masks;
int partners = 0;
float crowd = 0.0, dropped = 0.0, touched = 0.0;

// Whether two lattice neighbours share a joined node.
bool joined(ivec3 offset) {
    for (int corner = 0; corner < 8; ++corner) {
        ivec3 octant = cornerBits(corner ^ 7) + offset;
        if (any(lessThan(octant, ivec3(0))) || any(greaterThan(octant, ivec3(1)))) continue;
        int bit = octant.x | octant.y << 1 | octant.z << 2;
        if ((linkMaskOf(masks, corner) >> uint(bit) & 1u) != 0u) return true;
    }
    return false;
}

// Sphere pairs closer than the crowd's gap; gap: of the closest pair, m.
float closePairs(int other, BodyRecord otherBody, out float gap) {
    Proxy a = proxyOf(body), b = proxyOf(otherBody);
    float near = kCrowdGap * min(a.radius, b.radius), radii = a.radius + b.radius;
    if (sphereCount(a) == 1 && sphereCount(b) == 1) {
        gap = distance(centre.xyz, texelFetch(centres, ivec3(texelAddress(other), 0), 0).xyz) - radii;
        return gap < near ? 1.0 : 0.0;
    }
    Cell own = cellAt(self, body.cellSize.xyz), theirs = cellAt(other, otherBody.cellSize.xyz);
    float count = 0.0;
    gap = 1.0e30;
    for (int i = 0; i < sphereCount(a); ++i)
        for (int j = 0; j < sphereCount(b); ++j) {
            vec3 x, y, v;
            sphereOf(own, spherePlace(a, i), x, v);
            sphereOf(theirs, spherePlace(b, j), y, v);
            float between = distance(x, y) - radii;
            if (between < near) count += 1.0;
            gap = min(gap, between);
        }
    return count;
}

void consider(float number, ivec3 voxel) {
    int other = int(number) - 1;
    if (other == self) return;
    vec4 theirs = texelFetch(centres, ivec3(texelAddress(other), 0), 0);
    if (voxelOf(theirs.xyz) != voxel) return;  // another voxel of the same texel
    uvec4 otherRecord = cellRecord(other);
    BodyRecord otherBody = bodyRecord(bodyOf(otherRecord));
    float speed = distance(velocity.xyz, texelFetch(centres, ivec3(texelAddress(other), 1), 0).xyz);
    float margin = max(0.5 * (body.events.w + otherBody.events.w), 1.1 * searchInterval * speed);
    if (distance(centre.xyz, theirs.xyz) > centre.w + theirs.w + margin) return;
    ivec3 offset;
    if (latticeNeighbours(self, other, record, otherRecord, offset) && joined(offset)) return;
    float gap;
    crowd += closePairs(other, otherBody, gap);
    if (gap < 0.0 && record.y != otherRecord.y && length(velocity.xyz) > kSleepSpeed * body.cellSize.x)
        touched = max(touched, float(otherRecord.y) + 1.0);
    if (partners < 4) partnersLow[partners] = number;
    else if (partners < 8) partnersHigh[partners - 4] = number;
    if (partners < 8) ++partners;
    else dropped += 1.0;
}

void main() {
    partnersLow = partnersHigh = vec4(0.0);
    summary = vec4(0.0, 1.0, 0.0, 0.0);
    self = fragmentIndex();
    ivec2 texel = ivec2(gl_FragCoord.xy);
    centre = texelFetch(centres, ivec3(texel, 0), 0);
    if (centre.w == 0.0) return;
    velocity = texelFetch(centres, ivec3(texel, 1), 0);
    record = cellRecord(self);
    body = bodyRecord(bodyOf(record));
    masks = texelFetch(links, ivec3(texel, 0), 0);
    ivec3 own = voxelOf(centre.xyz);
    for (int i = 0; i < 27; ++i) {
        ivec3 voxel = own + ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        ivec2 at = voxelTexel(voxel);
        vec4 largest = texelFetch(grid, ivec3(at, 0), 0);
        if (largest == vec4(0.0)) continue;
        vec4 smallest = texelFetch(grid, ivec3(at, 1), 0);
        for (int c = 0; c < 4; ++c) {
            if (largest[c] > 0.0) consider(largest[c], voxel);
            if (smallest[c] < largest[c]) consider(smallest[c], voxel);
        }
        vec4 count = texelFetch(grid, ivec3(at, 2), 0);
        if (i == 13) dropped += dot(max(count - 2.0, 0.0), vec4(1.0));
    }
    summary = vec4(float(partners), max(crowd, 1.0), dropped, touched);
}
