// Where a cell's spheres are and how they move. Where its nodes lie is the solver's affair: gather/node.glsl.
#include "gather/node.glsl"
#include "physics/contact.glsl"

uniform samplerBuffer rest;       // xyz: rest position of a node, m
uniform samplerBuffer strengths;  // w: friction
uniform sampler2DArray centres;   // layer 0: centre of a cell, m; w: distance its spheres reach, m, 0 where no cell is
                                  // layer 1: its velocity, m/s; w: radius of its spheres, m

// A cell as its spheres need it: first corner at rest, edges (m), displacements (m) and velocities (m/s) of its corners.
struct Cell {
    vec3 origin;
    vec3 size;
    vec3 u[8];
    vec3 v[8];
};

Cell cellAt(int cell, vec3 size) {
    Cell result;
    result.origin = texelFetch(rest, 8 * cell).xyz;
    result.size = size;
    ivec2 texel = texelAddress(cell);
    for (int k = 0; k < 8; ++k) {
        result.u[k] = texelFetch(nodes, ivec3(texel, displacementLayer(k)), 0).xyz;
        result.v[k] = texelFetch(nodes, ivec3(texel, velocityLayer(k)), 0).xyz;
    }
    return result;
}

void sphereOf(Cell cell, vec3 place, out vec3 position, out vec3 velocity) {
    position = cell.origin + place * cell.size;
    velocity = vec3(0.0);
    for (int k = 0; k < 8; ++k) {
        float weight = cornerWeight(k, place);
        position += weight * cell.u[k];
        velocity += weight * cell.v[k];
    }
}
