// Contact search, third pass: one fragment per cell. Which cells it may touch until the next search (src/core/contact.hpp).
#include "gather/cell_texel.glsl"
#include "contact/grid.glsl"
#include "physics/contact.glsl"
#include "physics/links.glsl"

uniform sampler2DArray centres;  // contact/centre.frag
uniform sampler2DArray grid;     // contact/grid.glsl
uniform sampler2DArray links;    // layers of LinkRecord
uniform float searchInterval;    // s, until the next one

// What a cell touches: 0 nothing, 1 something, 2 + body: that body, which it hits so fast that it would wake it.
layout(location = 0) out vec4 summary;      // partners; N; how many there was no room for; what it touches
layout(location = 1) out vec4 partners[5];  // numbers of cells

const float kCreepSpeed = 0.3;  // cell edges/s, src/core/sleep.hpp

int self;
uvec4 record;
vec4 centre, velocity;
ivec4 lattice;
float shortestEdge;  // m
ivec3 place;  // on the lattice
uint neighbours;
int partnerCount = 0;
float crowd = 0.0, dropped = 0.0, touched = 0.0;

// Bit (x + 1) + 3 (y + 1) + 9 (z + 1): the cell so many steps away on the lattice shares a joined node.
uint joinedNeighbours(vec4 masks) {
    uint result = 0u;
    for (int corner = 0; corner < 8; ++corner) {
        uint mask = linkMaskOf(masks, corner);
        ivec3 own = cornerBits(corner ^ 7);
        for (int octant = 0; octant < 8; ++octant) {
            ivec3 offset = cornerBits(octant) - own + 1;
            result |= (mask >> uint(octant) & 1u) << uint(offset.x + 3 * offset.y + 9 * offset.z);
        }
    }
    return result;
}

// Whether a cell is one of them.
bool joined(int other) {
    int local = other - lattice.w;
    if (local < 0 || local >= lattice.x * lattice.y * lattice.z) return false;
    ivec3 offset = cellCoordinates(other, lattice) - place;
    if (any(greaterThan(abs(offset), ivec3(1)))) return false;
    return (neighbours >> uint(offset.x + 3 * offset.y + 9 * offset.z + 13) & 1u) != 0u;
}

void consider(int other, ivec3 voxel) {
    if (other == self || joined(other)) return;
    ivec2 texel = texelAddress(other);
    vec4 theirs = texelFetch(centres, ivec3(texel, 0), 0);
    if (voxelOf(theirs.xyz) != voxel) return;  // another voxel of the same texel
    vec4 moving = texelFetch(centres, ivec3(texel, 1), 0);
    float radii = centre.w + theirs.w, gap = distance(centre.xyz, theirs.xyz) - radii;
    float margin = max(0.5 * radii, 1.1 * searchInterval * distance(velocity.xyz, moving.xyz));
    if (gap > margin) return;
    uint otherBody = cellRecord(other).y;
    if (gap < kCrowdGap * min(centre.w, theirs.w)) crowd += 1.0;
    if (gap < 0.0 && otherBody != record.y && length(velocity.xyz) > kCreepSpeed * shortestEdge)
        touched = max(touched, float(otherBody) + 2.0);
    touched = max(touched, 1.0);
    if (partnerCount == 20) {
        dropped += 1.0;
        return;
    }
    vec4 slot = vec4(equal(ivec4(0, 1, 2, 3), ivec4(partnerCount & 3))) * float(other);
    for (int layer = 0; layer < 5; ++layer)
        if (layer == partnerCount >> 2) partners[layer] += slot;
    ++partnerCount;
}

void main() {
    for (int layer = 0; layer < 5; ++layer) partners[layer] = vec4(0.0);
    summary = vec4(0.0, 1.0, 0.0, 0.0);
    self = fragmentIndex();
    ivec2 texel = ivec2(gl_FragCoord.xy);
    centre = texelFetch(centres, ivec3(texel, 0), 0);
    if (centre.w == 0.0) return;
    velocity = texelFetch(centres, ivec3(texel, 1), 0);
    record = cellRecord(self);
    BodyRecord body = bodyRecord(bodyOf(record));
    lattice = ivec4(body.lattice);
    shortestEdge = min(body.cellSize.x, min(body.cellSize.y, body.cellSize.z));
    place = cellCoordinates(self, lattice);
    neighbours = joinedNeighbours(texelFetch(links, ivec3(texel, 0), 0));
    ivec3 own = voxelOf(centre.xyz);
    for (int i = 0; i < 27; ++i) {
        ivec3 voxel = own + ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        ivec2 at = voxelTexel(voxel);
        for (int half_ = 0; half_ < 2; ++half_) {
            vec4 largest = texelFetch(grid, ivec3(at, half_), 0);
            if (largest == vec4(0.0)) continue;
            vec4 smallest = texelFetch(grid, ivec3(at, 2 + half_), 0);
            for (int e = 0; e < 8; ++e) {
                float upper = largest[e & 3], number = e < 4 ? upper : smallest[e & 3];
                if (upper > 0.0 && (e < 4 || number < upper)) consider(int(number) - 1, voxel);
            }
            if (i == 13) dropped += dot(max(texelFetch(grid, ivec3(at, 4 + half_), 0) - 2.0, 0.0), vec4(1.0));
        }
    }
    summary = vec4(float(partnerCount), max(crowd, 1.0), dropped, touched);
}
