#include "draw/output.glsl"
#include "draw/surface.glsl"

uniform vec3 eye;
uniform usamplerBuffer cells;

in vec3 position;
in vec3 place;
flat in int cell;
flat in float inside;
flat in float boundary;

void main() {
    vec3 normal = normalize(cross(dFdx(position), dFdy(position)));
    uvec4 record = texelFetch(cells, cell);
    float seed = bodySeed(record.g);
    vec4 lit = shade(SurfacePoint(position, normal, place, record.r & SUNDER_CELL_LAW, inside, boundary, seed), eye);
    writeColour(lit, distance(eye, position));
}
