#include "draw/light.glsl"
#include "draw/lines.glsl"
#include "draw/paint.glsl"

uniform float wire;  // strength of the triangles' edges, 0 to 1

in vec3 position;
in vec2 facePosition;
flat in vec3 normal;
flat in vec3 baseColour;
flat in int paintedCell;
flat in float insideFace;
flat in uint cracks;
flat in float diagonalSlope;

out vec4 colour;

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
    vec3 light = lightAt(position, normalize(normal));

    // Freshly bared material is paler than a weathered outside.
    vec3 albedo = mix(baseColour, baseColour * 1.15 + 0.03, insideFace);
    float strength = lineStrength(facePosition);
    vec3 lit = paint(paintedCell, albedo) * paintLight(light);
    lit *= 1.0 - 0.55 * wire * strength * wireCoverage();
    lit *= 1.0 - 0.90 * strength * crackCoverage();
    colour = vec4(lit, 1.0);
}
