// Contact search, last pass: one fragment per sphere. Which spheres it may touch until the next search (src/core/contact.hpp).
#include "contact/sphere_texel.glsl"
#include "contact/storage.glsl"
#include "contact/grid.glsl"
#include "contact/joined.glsl"
#include "contact/left_out.glsl"
#include "physics/contact.glsl"

uniform sampler2DArray exposed;  // contact/exposed.frag
uniform sampler2DArray grid;     // contact/grid.glsl
uniform float reach;             // m, how far apart centres may be; 1.5 voxels
uniform float searchInterval;    // s, until the next one

// x: partners; y: of those close by, for N; z: what was left out (contact/left_out.glsl); w: what it touches: 0 nothing, 1 something, 2 + body:
// that body, which it hits so fast that it would wake it.
layout(location = 0) out vec4 summary;
// Spheres' numbers, which count from 1; negative: of a cell next to this one on the lattice.
layout(location = 1) out vec4 partners[7];

const float kReach = 1.501;     // voxels; rounding on top

int self;
uvec4 record;
vec4 centre;
vec3 velocity;
ivec3 strides;
uint around, joined;
vec4 list[7];
float listed = 0.0, close = 0.0, dropped = 0.0, touched = 0.0, fastest = 0.0;

// The bit (contact/joined.glsl) of the lattice neighbour that is so many cells further on in the numbering; 0: there is none.
uint neighbourBit(int steps) {
    uint bits = 0u;
    for (int i = 0; i < 9; ++i) {
        int x = steps - (i % 3 - 1) * strides.y - (i / 3 - 1) * strides.z;
        bits |= abs(x) <= 1 ? 1u << uint(3 * i + 1 + clamp(x, -1, 1)) : 0u;
    }
    return bits & around;
}

// Nothing is indexed at run time: that costs a trip to memory.
void add(float partner) {
    for (int i = 6; i > 0; --i) list[i] = vec4(list[i - 1].w, list[i].xyz);
    list[0] = vec4(partner, list[0].xyz);
    listed += 1.0;
}

void consider(int other, ivec3 voxel) {
    ivec2 address = sphereAddress(other);
    vec4 theirs = texelFetch(spheres, ivec3(address, 0), 0);
    vec3 between = centre.xyz - theirs.xyz;
    float apart = length(between);
    // Another voxel may share its texel.
    if (apart < reach && voxelOf(theirs.xyz) == voxel) {
        float radii = centre.w + theirs.w, gap = apart - radii;
        vec3 closing = velocity - texelFetch(spheres, ivec3(address, 1), 0).xyz;
        float way = 1.1 * searchInterval * length(closing);
        uint neighbour = neighbourBit(cellOf(other) - cellOf(self));
        if (gap < max(0.5 * radii, way) && (neighbour & joined) == 0u) {
            float nearest = closestApproach(between, closing, searchInterval) - radii;
            if (nearest < kCrowdGap * min(centre.w, theirs.w)) close += 1.0;
            // Others as fast may have passed by beyond its reach.
            fastest = max(fastest, way / (reach - radii));
            touched = max(touched, 1.0);
            if (nearest < 0.0 && neighbour == 0u && length(velocity) > kCreepSpeed * 2.0 * centre.w) {
                uint otherBody = cellRecord(cellOf(other)).y;
                if (otherBody != record.y) touched = max(touched, float(otherBody) + 2.0);
            }
            if (listed < float(kMostPartners)) add(neighbour != 0u ? -float(other + 1) : float(other + 1));
            else dropped += 1.0;
        }
    }
}

// Numbers that are not among the known ones; 0 instead of those that are.
vec4 unlessAmong(vec4 numbers, vec4 known) {
    numbers = mix(numbers, vec4(0.0), equal(numbers, known.xxxx));
    numbers = mix(numbers, vec4(0.0), equal(numbers, known.yyyy));
    numbers = mix(numbers, vec4(0.0), equal(numbers, known.zzzz));
    return mix(numbers, vec4(0.0), equal(numbers, known.wwww));
}
float countOf(vec4 numbers) { return dot(vec4(greaterThan(numbers, vec4(0.0))), vec4(1.0)); }

vec2 halvesOf(vec4 numbers) {
    return numberHalves(numbers.x) + numberHalves(numbers.y) + numberHalves(numbers.z) + numberHalves(numbers.w);
}

// All spheres in a voxel.
void visit(ivec3 voxel) {
    ivec2 texel = voxelTexel(voxelHash(voxel));
    vec4 extremes = texelFetch(grid, ivec3(texel, 0), 0);
    if (extremes.w == 0.0) return;
    float largest = extremes.x, smallest = kNumbers - extremes.y;
    vec4 first = vec4(largest, smallest < largest ? smallest : 0.0, 0.0, 0.0), second = vec4(0.0), third = vec4(0.0);
    int places = 2;
    if (extremes.w > 2.0) {
        second = texelFetch(grid, ivec3(texel, 1), 0);
        third = texelFetch(grid, ivec3(texel, 2), 0);
        vec2 rest = vec2(second.w, third.w) - halvesOf(first);
        places = 3;
        if (extremes.w > 3.0) {
            vec3 high = unscrambled(vec3(extremes.z, third.x, third.z)), low = unscrambled(vec3(0.0, kNumbers - third.y, 0.0));
            first.z = high.x != largest && high.x != smallest ? high.x : 0.0;
            second = unlessAmong(vec4(second.xyz, 0.0), first);
            third = unlessAmong(unlessAmong(vec4(high.y, low.y, high.z, 0.0), first), second);
            if (third.z == third.x || third.z == third.y) third.z = 0.0;
            rest -= numberHalves(first.z) + halvesOf(second) + halvesOf(third);
            float missing = extremes.w - countOf(first) - countOf(second) - countOf(third);
            if (missing == 1.0) third.w = numberOf(rest);
            else if (largest == float(self + 1)) dropped += missing;
            places = 12;
        } else {
            first.z = numberOf(rest);
        }
    }
    for (int i = 0; i < places; ++i) {
        int other = int(first.x) - 1;
        if (other >= 0 && cellOf(other) != cellOf(self)) consider(other, voxel);
        // The next one comes first.
        first = vec4(first.yzw, second.x);
        second = vec4(second.yzw, third.x);
        third = vec4(third.yzw, 0.0);
    }
}

void main() {
    summary = vec4(0.0);
    for (int i = 0; i < 7; ++i) partners[i] = list[i] = vec4(0.0);
    if (texelFetch(exposed, ivec3(gl_FragCoord.xy, 0), 0).x == 0.0) return;
    self = fragmentSphere();
    centre = texelFetch(spheres, ivec3(gl_FragCoord.xy, 0), 0);
    velocity = texelFetch(spheres, ivec3(gl_FragCoord.xy, 1), 0).xyz;
    record = cellRecord(cellOf(self));
    strides = cellStrides(ivec4(bodyRecord(bodyOf(record)).lattice));
    around = latticeNeighbours(record.x);
    joined = joinedNeighbours(linkMasksOf(cellOf(self)));
    ivec3 low = voxelOf(centre.xyz - reach);
    vec3 from = inGrid(centre.xyz) - vec3(low);  // voxels, of the first of 4 × 4 × 4
    for (int i = 0; i < 64; ++i) {
        ivec3 step_ = ivec3(i >> 4, i >> 2 & 3, i & 3);
        vec3 beside = max(max(vec3(step_) - from, from - vec3(step_) - 1.0), 0.0);  // voxels, to the nearest point
        if (dot(beside, beside) < kReach * kReach) visit(low + step_);
    }
    float haste = clamp(ceil(4.0 * log2(max(fastest, 1.0))), 0.0, 255.0);
    summary = vec4(listed, close, leftOut(dropped, haste), touched);
    for (int i = 0; i < 7; ++i) partners[i] = list[i];
}
