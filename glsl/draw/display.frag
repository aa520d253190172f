#include "draw/output.glsl"
#include "draw/painted_light.glsl"
#include "draw/surface.glsl"

uniform vec3 eye;

in vec3 position;
in vec3 normal;
in vec3 place;
flat in uint surfaceLaw;
flat in float seed;
flat in int paintedCell;
flat in float insideFace;
flat in float boundaryFace;

void main() {
    vec3 n = normalize(cross(dFdx(position), dFdy(position)));
    if (insideFace == 0.0 && dot(normal, n) > 0.0) n = normalize(normal);
    vec4 lit = painted ? vec4(paintedLight(paintedCell, position, n), 1.0)
                       : shade(SurfacePoint(position, n, place, surfaceLaw, insideFace, boundaryFace, seed), eye);
    writeColour(lit, distance(eye, position), !painted);
}
