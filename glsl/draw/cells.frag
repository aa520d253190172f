#include "draw/lines.glsl"
#include "draw/output.glsl"
#include "draw/surface.glsl"
#include "draw/painted_light.glsl"

uniform vec3 eye;
uniform float wire;  // strength of the triangles' edges, 0 to 1

in vec3 position;
in vec3 place;
in vec2 facePosition;
flat in vec3 normal;
flat in uint surfaceLaw;
flat in float seed;
flat in int paintedCell;
flat in float insideFace;
flat in float boundaryFace;
flat in uint cracks;
flat in float diagonalSlope;

float crackCoverage() {
    const float HALF_WIDTH = 0.8;  // px; the neighbour beyond the edge draws the other half
    vec4 edges = vec4(lineCoverage(facePosition.x, HALF_WIDTH), lineCoverage(facePosition.x - 1.0, HALF_WIDTH),
                      lineCoverage(facePosition.y, HALF_WIDTH), lineCoverage(facePosition.y - 1.0, HALF_WIDTH));
    vec4 mask = vec4((uvec4(cracks) >> uvec4(0, 1, 2, 3)) & 1u);
    edges *= mask;
    return max(max(edges.x, edges.y), max(edges.z, edges.w));
}

float wireCoverage() {
    const float HALF_WIDTH = 0.5;
    vec2 centred = 0.5 - abs(facePosition - 0.5);
    float edges = max(lineCoverage(centred.x, HALF_WIDTH), lineCoverage(centred.y, HALF_WIDTH));
    vec2 p = facePosition - 0.5;
    return max(edges, lineCoverage(p.x - diagonalSlope * p.y, HALF_WIDTH));
}

void main() {
    vec3 n = normalize(normal);
    vec4 lit = painted ? vec4(paintedLight(paintedCell, position, n), 1.0)
                       : shade(SurfacePoint(position, n, place, surfaceLaw, insideFace, boundaryFace, seed), eye);
    float strength = lineStrength(facePosition);
    float lines = 0.55 * wire * strength * wireCoverage();
    float crack = 0.90 * strength * crackCoverage();
#ifdef TRANSPARENT
    // A crack in glass is white: it scatters the light that it does not let through.
    lit = mix(lit, vec4(skyLight(n), 1.0), 0.8 * crack);
    lit = mix(lit, vec4(0.0, 0.0, 0.0, 1.0), lines);
#else
    lit.rgb *= (1.0 - lines) * (1.0 - crack);
#endif
    writeColour(lit, distance(eye, position), !painted);
}
