// A cell as objects see it: a rounded box that follows its nodes.
#include "contact/proxy.glsl"
#include "contact/storage.glsl"
#include "objects/motion.glsl"

uniform samplerBuffer rest;  // xyz: rest position of a node, m

struct CellMotion {
    vec3 position[8];  // m
    vec3 velocity[8];  // m/s
};

CellMotion cellMotion(int cell) {
    CellMotion result;
    for (int corner = 0; corner < 8; ++corner) {
        result.velocity[corner] = velocityOf(cell, corner);
        result.position[corner] = texelFetch(rest, 8 * cell + corner).xyz + displacementOf(cell, corner);
    }
    return result;
}

vec3 meanOf(vec3 field[8]) {
    return 0.125 * (field[0] + field[1] + field[2] + field[3] + field[4] + field[5] + field[6] + field[7]);
}

// Edges that have become shorter than half or longer than twice what they are at rest count as that.
float boxEdge(vec3 axis, vec3 mean, float atRest) { return clamp(abs(dot(axis, mean)), 0.5 * atRest, 2.0 * atRest); }

// edges: at rest, m.
RoundedBox cellBox(CellMotion cell, vec3 edges) {
    vec3 x = vec3(0.0), y = vec3(0.0), z = vec3(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        vec3 signs = 0.25 * (2.0 * vec3(cornerBits(corner)) - 1.0);
        x += signs.x * cell.position[corner];
        y += signs.y * cell.position[corner];
        z += signs.z * cell.position[corner];
    }
    // Gram–Schmidt; a cell squashed flat gets some axes.
    vec3 first = length(x) > 1.0e-6 ? normalize(x) : vec3(1.0, 0.0, 0.0);
    vec3 across = y - first * dot(first, y);
    vec3 other = abs(first.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    vec3 second = normalize(length(across) > 1.0e-6 ? across : cross(first, other));
    vec3 third = cross(first, second);
    RoundedBox box;
    box.centre = meanOf(cell.position);
    box.axes = mat3(first, second, third);
    box.radius = kCellRoundness * min(edges.x, min(edges.y, edges.z));
    box.half_ = 0.5 * vec3(boxEdge(first, x, edges.x), boxEdge(second, y, edges.y), boxEdge(third, z, edges.z)) - box.radius;
    return box;
}

// Weights of the corners for an impulse at x, in order: cornerWeights() in src/core/object_contact.cpp.
// margin: half a sphere's share of the cell along each axis.
void cornerWeights(RoundedBox box, vec3 margin, vec3 x, out float weights[8]) {
    vec3 local = (x - box.centre) * box.axes;
    vec3 place = clamp(0.5 + 0.5 * local / (box.half_ + box.radius), margin, 1.0 - margin);
    for (int corner = 0; corner < 8; ++corner) weights[corner] = cornerWeight(place, corner);
}
