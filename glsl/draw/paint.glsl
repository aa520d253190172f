// Colours that show something about each cell in place of its material (src/render/cell_colours.hpp).
uniform samplerBuffer cellColours;  // linear RGB, one texel per cell
uniform bool painted;

// What a surface of `cell` is to be seen as.
vec3 paint(int cell, vec3 albedo) {
    return painted ? texelFetch(cellColours, cell).rgb : albedo;
}

// The light on it. Painted colours are compared with a legend's: in the sun they are the legend's, in the shade a little darker
// and of the same hue, which is enough to tell shapes by.
vec3 paintLight(vec3 light) {
    const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);
    const float SUNLIT = 0.7;  // on a wall that the sun meets at a slant
    return painted ? vec3(mix(0.5, 1.0, min(dot(light, LUMINANCE) / SUNLIT, 1.0))) : light;
}
