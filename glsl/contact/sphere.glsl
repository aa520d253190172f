// Where a cell's sphere is and how it moves: the mean of its corners. Where its nodes lie is the solver's affair: gather/node.glsl.
#include "gather/node.glsl"
#include "physics/contact.glsl"

uniform samplerBuffer rest;  // xyz: rest position of a node, m

// size: of the cell, m.
void sphereOf(int cell, vec3 size, out vec3 position, out vec3 velocity) {
    position = texelFetch(rest, 8 * cell).xyz + 0.5 * size;
    velocity = vec3(0.0);
    ivec2 texel = texelAddress(cell);
    for (int k = 0; k < 8; ++k) {
        position += 0.125 * texelFetch(nodes, ivec3(texel, displacementLayer(k)), 0).xyz;
        velocity += 0.125 * texelFetch(nodes, ivec3(texel, velocityLayer(k)), 0).xyz;
    }
}
