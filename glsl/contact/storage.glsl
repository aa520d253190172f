// Where the solver keeps what contact reads of its nodes and joints: in textures (gather) or, with BUFFERS, in buffers (scatter).
#include "physics/lattice.glsl"

#if BUFFERS
uniform samplerBuffer nodes;  // NodeRecord
uniform samplerBuffer links;  // LinkRecord

vec3 displacementOf(int cell, int corner) { return texelFetch(nodes, 2 * (8 * cell + corner)).xyz; }
vec3 velocityOf(int cell, int corner) { return texelFetch(nodes, 2 * (8 * cell + corner) + 1).xyz; }
vec4 linkMasksOf(int cell) { return texelFetch(links, SUNDER_LINK_TEXELS * cell); }
vec4 inverseMassesOf(int cell, int four) { return texelFetch(links, SUNDER_LINK_TEXELS * cell + 1 + four); }
#else
uniform sampler2DArray nodes;  // gather/node.glsl
uniform sampler2DArray links;  // layers of LinkRecord

vec3 displacementOf(int cell, int corner) { return texelFetch(nodes, ivec3(texelAddress(cell), 2 * corner), 0).xyz; }
vec3 velocityOf(int cell, int corner) { return texelFetch(nodes, ivec3(texelAddress(cell), 2 * corner + 1), 0).xyz; }
vec4 linkMasksOf(int cell) { return texelFetch(links, ivec3(texelAddress(cell), 0), 0); }
vec4 inverseMassesOf(int cell, int four) { return texelFetch(links, ivec3(texelAddress(cell), 1 + four), 0); }
#endif
