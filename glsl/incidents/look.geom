// Look for incidents: a record for each, the cell's breaks first.
#include "contact/storage.glsl"

uniform samplerBuffer rest;  // xyz: rest position of a node, m

layout(points) in;
layout(points, max_vertices = 4) out;

flat in int cell[];
flat in int broken[];
flat in float impulse[];
flat in uint partner[];

flat out vec4 placeImpulse;  // m; N·s, of a contact
flat out ivec4 what;         // cell; axis of the bond, 3: a contact; who pushed hardest (incidents/rank.glsl)

// Mean of the corners that have all of these bits.
vec3 centre(int bits) {
    vec4 sum = vec4(0.0);
    for (int corner = 0; corner < 8; ++corner)
        if ((corner & bits) == bits)
            sum += vec4(texelFetch(rest, 8 * cell[0] + corner).xyz + displacementOf(cell[0], corner), 1.0);
    return sum.xyz / sum.w;
}

void report(vec3 place, float impulse_, int axis) {
    gl_Position = vec4(0.0);
    placeImpulse = vec4(place, impulse_);
    what = ivec4(cell[0], axis, int(partner[0]), 0);
    EmitVertex();
    EndPrimitive();
}

void main() {
    for (int axis = 0; axis < 3; ++axis)
        if ((broken[0] >> axis & 1) != 0) report(centre(1 << axis), 0.0, axis);
    if (impulse[0] > 0.0) report(centre(0), impulse[0], 3);
}
