#include "draw/output.glsl"
#include "draw/surface.glsl"

uniform vec3 eye;

in vec3 position;
in vec3 place;
flat in uint surfaceLaw;
flat in float seed;
flat in float insideFace;
flat in float boundaryFace;

void main() {
    // Flat: torn faces are. Towards the eye, for triangles that are seen from the side.
    vec3 normal = normalize(cross(dFdx(position), dFdy(position)));
    vec4 lit = shade(SurfacePoint(position, normal, place, surfaceLaw, insideFace, boundaryFace, seed), eye);
    writeColour(lit, distance(eye, position));
}
