// Painted surfaces with light on them. Their colours are compared with a legend's: in the sun they are the legend's, in the shade a
// little darker and of the same hue, which is enough to tell shapes by.
#include "draw/light.glsl"
#include "draw/paint.glsl"

// Linear RGB of the screen, not of light. At p, on a surface with the unit normal n.
vec3 paintedLight(int cell, vec3 p, vec3 n) {
    const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);
    const float SUNLIT = 0.7;  // on a wall that the sun meets at a slant
    float light = dot(diffuseLight(p, n), LUMINANCE);
    return paint(cell, vec3(0.0)) * mix(0.5, 1.0, min(light / SUNLIT, 1.0));
}
