// What objects give a cell, scattered to the texels of its nodes.
#include "scatter/textures.glsl"

layout(points) in;
layout(points, max_vertices = 8) out;

in CellForces {
    flat vec3 force[8];  // N
    flat int cell;
} given[];
out vec4 combinedForce;

uniform float targetHeight;  // rows of the forces

void main() {
    if (gl_in[0].gl_Position.x > 1.0) return;
    for (int corner = 0; corner < 8; ++corner) {
        gl_Position = texelPosition(8 * given[0].cell + corner, targetHeight);
        combinedForce = vec4(given[0].force[corner], 0.0);
        EmitVertex();
        EndPrimitive();
    }
}
