// Scatters a tetrahedron's results to texels (thesis, figure 7.2): one point per nodal force and, every few steps, one for the
// eigenvector and eigenvalue plus two for the stress that bonds are tested with.
#include "scatter/textures.glsl"

layout(points) in;
#if FRACTURE
layout(points, max_vertices = 7) out;
#else
layout(points, max_vertices = 4) out;
#endif

flat in ivec4 elementNodes[];
in vec3 force0[];
in vec3 force1[];
in vec3 force2[];
in vec3 force3[];
out vec4 combinedForce;
#if FRACTURE
flat in int elementIndex[];
in vec4 principal[];
in vec3 biotNormal[];
in vec3 biotShear[];
out vec4 combinedStress;
#endif

uniform float targetHeight;  // rows of the render targets

void emitForce(int node, vec3 force) {
    gl_Position = texelPosition(node, targetHeight);
    combinedForce = vec4(force, 0.0);
#if FRACTURE
    combinedStress = vec4(0.0);
#endif
    EmitVertex();
    EndPrimitive();
}

#if FRACTURE
void emitStress(int texel, vec4 value) {
    gl_Position = texelPosition(SUNDER_STRESS_TEXELS * elementIndex[0] + texel, targetHeight);
    combinedForce = vec4(0.0);
    combinedStress = value;
    EmitVertex();
    EndPrimitive();
}
#endif

void main() {
    emitForce(elementNodes[0].x, force0[0]);
    emitForce(elementNodes[0].y, force1[0]);
    emitForce(elementNodes[0].z, force2[0]);
    emitForce(elementNodes[0].w, force3[0]);
#if FRACTURE
    emitStress(SUNDER_STRESS_PRINCIPAL, principal[0]);
    emitStress(SUNDER_STRESS_NORMAL, vec4(biotNormal[0], 0.0));
    emitStress(SUNDER_STRESS_SHEAR, vec4(biotShear[0], 0.0));
#endif
}
