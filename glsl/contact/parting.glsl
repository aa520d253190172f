// Bodies that overlap as the world begins, and how they part (src/core/overlap.hpp).
#include "contact/sphere.glsl"

uniform samplerBuffer partings;  // SUNDER_PARTING_TEXELS per pair, by its first body, then its second
uniform int partingCount;
uniform samplerBuffer rest;      // xyz: rest position of a node, m
uniform float fastestParting;    // m/s

// m, from where it is at rest.
vec3 movedBy(int sphere, vec3 centre) {
    BodyRecord body = bodyRecord(bodyOf(cellRecord(cellOf(sphere))));
    return centre - texelFetch(rest, 8 * cellOf(sphere)).xyz -
           alongAxes(body, placeInCell(sphere, sphereCounts(body)) * body.cellSize.xyz);
}

// Of two spheres, the lower number first, with centres x and y: the way out, or 0 where the overlap is over; the speed their bodies
// are pushed to, m/s, or -1 where they do not overlap as the world begins.
void partingOf(int first, int second, vec3 x, vec3 y, out vec3 way, out float pushSpeed) {
    way = vec3(0.0);
    pushSpeed = -1.0;
    float a = float(bodyOf(cellRecord(cellOf(first)))), b = float(bodyOf(cellRecord(cellOf(second))));
    int from = 0, end = partingCount;
    while (from < end) {
        int middle = (from + end) / 2;
        vec4 low = texelFetch(partings, SUNDER_PARTING_TEXELS * middle);
        vec4 high = texelFetch(partings, SUNDER_PARTING_TEXELS * middle + 1);
        if (low.w == a && high.w == b) {
            vec3 moved = movedBy(first, x) - movedBy(second, y);
#ifdef TURNED
            int axes = SUNDER_PARTING_TEXELS * middle + 3;
            moved = moved * mat3(texelFetch(partings, axes).xyz, texelFetch(partings, axes + 1).xyz,
                                 texelFetch(partings, axes + 2).xyz);
#endif
            if (all(greaterThan(moved, low.xyz)) && all(lessThan(moved, high.xyz)))
                way = texelFetch(partings, SUNDER_PARTING_TEXELS * middle + 2).xyz;
            pushSpeed = kPushShare * fastestParting;
            return;
        }
        if (low.w < a || (low.w == a && high.w < b)) from = middle + 1;
        else end = middle;
    }
}
