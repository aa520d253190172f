// Passes over cells: the texel that a pass fills is the number of what it computes. A fragment computes one, or with COMPUTE an
// invocation, of which there are as many to a cell as the pass has groups along y.
#include "physics/lattice.glsl"

#ifdef COMPUTE
layout(local_size_x = SUNDER_CELL_GROUP) in;
layout(rgba32f) writeonly uniform image2DArray target;
uniform isamplerBuffer cellGroups;  // for each group along x: its first cell, and how many it has

// Its cell; -1: none.
int invocationCell() {
    ivec2 group = texelFetch(cellGroups, int(gl_WorkGroupID.x)).xy;
    int local = int(gl_LocalInvocationID.x);
    return local < group.y ? group.x + local : -1;
}
#else
int fragmentIndex() { return (int(gl_FragCoord.y) << textureShift) + int(gl_FragCoord.x); }
#endif
