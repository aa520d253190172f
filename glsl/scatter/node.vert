// Node update (thesis, figure 6.5): one vertex per node, written back by transform feedback.
#include "physics/lattice.glsl"
#include "physics/events.glsl"
#include "physics/integrate.glsl"
#include "scatter/textures.glsl"

uniform sampler2D cumulativeForces;
uniform samplerBuffer rest;  // xyz: rest position, m
uniform float stepInFrame;

in vec4 displacement;
in vec4 velocity;
out vec4 newDisplacement;
out vec4 newVelocity;

void main() {
    newDisplacement = displacement;
    newVelocity = vec4(0.0);
    vec4 force = texelFetch(cumulativeForces, texelAddress(gl_VertexID), 0);
    if (force.a == 0.0) return;  // anchored, or no cell here
    int index = bodyOf(cellRecord(gl_VertexID >> 3));
    BodyRecord body = bodyRecord(index);
    vec3 restPosition = texelFetch(rest, gl_VertexID).xyz;
    vec3 u = displacement.xyz, v = velocity.xyz;
    moveNode(force.rgb, force.a, body, eventAcceleration(index, restPosition, u, stepInFrame), restPosition, u, v);
    newDisplacement = vec4(u, displacement.w);
    newVelocity = vec4(v, 0.0);
}
