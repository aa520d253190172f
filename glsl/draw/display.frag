#include "shared/layout.h"
#include "draw/light.glsl"

layout(std140) uniform ElementLaws {
    ElementLaw laws[SUNDER_MAX_ELEMENT_LAWS];
};
uniform usamplerBuffer cells;

in vec3 position;
in vec3 place;
flat in int cell;
flat in float inside;
flat in float boundary;

out vec4 colour;

void main() {
    vec3 normal = normalize(cross(dFdx(position), dFdy(position)));
    vec3 albedo = laws[texelFetch(cells, cell).r & SUNDER_CELL_LAW].colour.rgb;
    albedo = mix(albedo, albedo * 1.3 + 0.05, inside);
    colour = vec4(albedo * lightAt(position, normal), 1.0);
}
