// Colours that show something about each cell in place of its material (src/render/cell_colours.hpp).
uniform samplerBuffer cellColours;  // linear RGB, one texel per cell
uniform bool painted;

// What a surface of `cell` is to be seen as.
vec3 paint(int cell, vec3 albedo) {
    return painted ? texelFetch(cellColours, cell).rgb : albedo;
}
