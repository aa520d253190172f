// A hashed grid of voxels, one texel each, in three layers. Cells fall into four classes by their lattice coordinates, so that
// neighbours rarely share one. For each class a voxel keeps the largest number of the cells in it (layer 0) and the smallest
// (layer 1), plus one, and counts them (layer 2): eight cells in one pass of blending, and more are noticed.
uniform ivec2 gridBits;    // columns and rows are these powers of two
uniform float voxelSize;  // m
const float kNobody = 3.0e7;  // beyond every number, in layer 1

ivec3 voxelOf(vec3 position) { return ivec3(floor(clamp(position / voxelSize, -1.0e6, 1.0e6))); }

ivec2 voxelTexel(ivec3 voxel) {
    uint hash = uint(voxel.x) * 73856093u ^ uint(voxel.y) * 19349663u ^ uint(voxel.z) * 83492791u;
    hash ^= hash >> 15u;
    hash *= 2246822519u;
    hash ^= hash >> 13u;
    return ivec2(hash & ((1u << uint(gridBits.x)) - 1u), hash >> uint(gridBits.x) & ((1u << uint(gridBits.y)) - 1u));
}
