// Object search, one point per cell: the objects that may touch it until the next search (src/cpu/objects.cpp, findOf()).
#include "objects/cell.glsl"

uniform float searchInterval;  // s

flat out int cell;
flat out uvec2 near;     // numbers of objects plus one, a byte each
flat out int nearCount;  // may be more than fit into `near`

void main() {
    cell = gl_VertexID;
    near = uvec2(0u);
    nearCount = 0;
    uvec4 record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return;
    vec3 edges = bodyRecord(bodyOf(record)).cellSize.xyz;
    CellMotion nodes_ = cellMotion(cell);
    vec3 centre = meanOf(nodes_.position), velocity = meanOf(nodes_.velocity);
    float shortest = min(edges.x, min(edges.y, edges.z)), cellReach = 0.5 * length(edges);
    for (int i = 0; i < objectCount; ++i) {
        ObjectMotion state = objectMotion(i);
        ObjectRecord object = objectRecord(i);
        vec3 spin = spinOf(object, state.orientation, state.angularMomentum.xyz);
        float reach = length(object.shape.xyz) + object.shape.w;
        float speed = distance(velocity, state.velocity.xyz) + length(spin) * reach;
        float margin = max(0.5 * shortest, 1.1 * searchInterval * speed);
        float gap = distance(centre, nearestPoint(boxOf(object, state), centre)) - object.shape.w - cellReach;
        if (state.position.w > 0.0 && gap <= margin) {
            uint number = uint(i + 1);
            if (nearCount < 4) near.x |= number << uint(8 * nearCount);
            else if (nearCount < 8) near.y |= number << uint(8 * nearCount - 32);
            ++nearCount;
        }
    }
}
