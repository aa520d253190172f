// Bricks and planks: which one a place belongs to, exactly as clusterOf() in src/core/strength_map.cpp has it.
#include "shared/layout.h"

// `place` in units of clusters, odd rows of bricks shifted by half; 0 along axes without boundaries.
vec3 clusterCoordinates(SurfaceLook look, vec3 place) {
    vec3 size = look.clusters.xyz;
    vec3 q = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis)
        if (size[axis] > 0.0) q[axis] = place[axis] / size[axis];
    if (int(look.clusters.w) == SUNDER_CLUSTERS_RUNNING_BOND) q.x += 0.5 * float(int(floor(q.y)) & 1);
    return int(look.clusters.w) == SUNDER_CLUSTERS_NONE ? vec3(0.0) : q;
}

ivec3 clusterAt(SurfaceLook look, vec3 place) {
    return ivec3(floor(clusterCoordinates(look, place)));
}

// Whether things come apart between two places because the one is another brick or plank than the other.
bool clustersPart(SurfaceLook look, vec3 a, vec3 b) {
    return int(look.clusters.w) != SUNDER_CLUSTERS_BOARDS && clusterAt(look, a) != clusterAt(look, b);
}
