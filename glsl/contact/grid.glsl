// A hashed grid of voxels, one texel each, in three layers. Layer 0: of the numbers of the spheres in a voxel, which count from 1, the
// largest; kNumbers less the smallest; the largest in the first other order; how many there are. Layer 1: the largest in each of three
// pairs of opposite eighths of the voxel. Layer 2: the largest, and kNumbers less the smallest, in the second other order; the largest
// in the third. The last components of layers 1 and 2 are the sums of the numbers' halves (numberHalves()).
//
// A voxel is as wide as the largest sphere, so that more than three in it are rare. Up to three are found for sure; of four it loses
// two in a hundred times, and counts them. Where voxels begin changes from search to search, so that none is lost for long.
#include "physics/lattice.glsl"

uniform ivec2 gridBits;             // columns and rows are these powers of two
uniform float voxelsPerMetre;       // a factor: quotients may differ from stage to stage
uniform vec3 gridShift;             // voxels
const float kNumbers = 16777216.0;  // 2^24

// In voxels; the same in every shader stage.
vec3 inGrid(vec3 position) {
    precise vec3 scaled = clamp(position * voxelsPerMetre, -1.0e6, 1.0e6);
    precise vec3 shifted = scaled + gridShift;
    return shifted;
}

ivec3 voxelOf(vec3 position) { return ivec3(floor(inGrid(position))); }

uint voxelHash(ivec3 voxel) {
    uint hash = uint(voxel.x) * 73856093u ^ uint(voxel.y) * 19349663u ^ uint(voxel.z) * 83492791u;
    hash ^= hash >> 15u;
    hash *= 2246822519u;
    return hash ^ hash >> 13u;
}

ivec2 voxelTexel(uint hash) {
    return ivec2(hash & ((1u << uint(gridBits.x)) - 1u), hash >> uint(gridBits.x) & ((1u << uint(gridBits.y)) - 1u));
}

// Which of the four pairs of eighths of its voxel a position lies in; another one for each of two voxels that share a texel.
int eighthsOf(vec3 position, uint hash) {
    ivec3 high = ivec3(greaterThanEqual(fract(inGrid(position)), vec3(0.5)));
    return (high.x ^ high.z | (high.y ^ high.z) << 1) ^ int(hash >> 30u);
}

// Numbers in other orders, and back: times an odd number, modulo 2^24. 0 stays 0.
const uvec3 kScramble = uvec3(10368889u, 5588547u, 14414443u), kUnscramble = uvec3(11764425u, 7911019u, 8268355u);
vec3 scrambled(float number) { return vec3(uint(number) * kScramble & 16777215u); }
vec3 unscrambled(vec3 keys) { return vec3(uvec3(keys) * kUnscramble & 16777215u); }

// A number's upper and lower twelve bits: sums of a few of them are exact.
vec2 numberHalves(float number) {
    float upper = floor(number / 4096.0);
    return vec2(upper, number - 4096.0 * upper);
}
float numberOf(vec2 halves) { return 4096.0 * halves.x + halves.y; }
