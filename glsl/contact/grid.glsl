// A hashed grid of voxels, one texel each, in six layers. Of the cells in each eighth of a voxel it keeps the largest number (layers
// 0 and 1, four eighths each) and the smallest (layers 2 and 3), plus one, and counts them (layers 4 and 5). An eighth is smaller
// than a cell, so that more than two in it are rare, and noticed.
uniform ivec2 gridBits;    // columns and rows are these powers of two
uniform float voxelSize;  // m
const float kNobody = 3.0e7;  // beyond every number, in layers 2 and 3

ivec3 voxelOf(vec3 position) { return ivec3(floor(clamp(position / voxelSize, -1.0e6, 1.0e6))); }

// Which eighth of its voxel a position lies in.
int eighthOf(vec3 position) {
    ivec3 half_ = ivec3(greaterThanEqual(fract(position / voxelSize), vec3(0.5)));
    return half_.x | half_.y << 1 | half_.z << 2;
}

ivec2 voxelTexel(ivec3 voxel) {
    uint hash = uint(voxel.x) * 73856093u ^ uint(voxel.y) * 19349663u ^ uint(voxel.z) * 83492791u;
    hash ^= hash >> 15u;
    hash *= 2246822519u;
    hash ^= hash >> 13u;
    return ivec2(hash & ((1u << uint(gridBits.x)) - 1u), hash >> uint(gridBits.x) & ((1u << uint(gridBits.y)) - 1u));
}
