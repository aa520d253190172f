// The textures of surfaces (src/render/surface_textures.hpp). A texel: brightness, half of the factor on a material's colour;
// roughness; slopes along both coordinates, -1 to 1 as 0 to 1.
#include "draw/surface_layers.h"

uniform sampler2DArray surfaces;
uniform int surfaceLayers[SUNDER_SURFACE_LAYERS];  // where each is in the array; only those that the world needs are there

// Slow variation from 0 to 2, 1 on average, over coordinates in m: what keeps the repeating of a layer from being seen. It has no
// fine detail that would be worth an anisotropic fetch.
float wideVariation(vec2 p, vec2 across, vec2 up) {
    const float SIZE = 2.7;  // m
    float texels = max(length(across), length(up)) * float(textureSize(surfaces, 0).x) / SIZE;
    return 2.0 * textureLod(surfaces, vec3(p / SIZE, surfaceLayers[SUNDER_LAYER_CLOUDS]), log2(max(texels, 1e-6))).r;
}

// m, what a layer covers before it repeats.
vec2 layerSize(int layer) {
    if (layer == SUNDER_LAYER_WOOD) return vec2(0.4, 1.6);
    if (layer == SUNDER_LAYER_WOOD_SPLIT) return vec2(0.4, 0.8);
    if (layer == SUNDER_LAYER_WOOD_END) return vec2(0.4, 0.4);
    if (layer == SUNDER_LAYER_CONCRETE) return vec2(1.2);
    return vec2(0.5);
}
