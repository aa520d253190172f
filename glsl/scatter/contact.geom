// Scatters what pushes a cell to the texels of its eight nodes.
#include "contact/corner_forces.glsl"
#include "scatter/textures.glsl"

layout(points) in;
layout(points, max_vertices = 8) out;

flat in int cellIndex[];
out vec4 combinedForce;

uniform float targetHeight;  // rows of the render target

void main() {
    int cell = cellIndex[0];
    if (!touches(cell)) return;
    vec3 forces[8];
    cornerForces(cell, forces);
    for (int k = 0; k < 8; ++k) {
        gl_Position = texelPosition(8 * cell + k, targetHeight);
        combinedForce = vec4(forces[k], 0.0);
        EmitVertex();
        EndPrimitive();
    }
}
