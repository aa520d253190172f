// Makes a texel of the surface textures (draw/surface_layers.glsl) from what bake/surface.frag drew.
#include "draw/surface_layers.glsl"

uniform sampler2D bakedLayer;  // brightness, roughness, height (m)
uniform int layer;

out vec4 texel;

float heightAt(ivec2 at, int side) {
    return texelFetch(bakedLayer, (at + side) % side, 0).b;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int side = textureSize(bakedLayer, 0).x;
    vec4 baked = texelFetch(bakedLayer, at, 0);
    vec2 rise = vec2(heightAt(at + ivec2(1, 0), side) - heightAt(at - ivec2(1, 0), side),
                     heightAt(at + ivec2(0, 1), side) - heightAt(at - ivec2(0, 1), side));
    vec2 slope = rise * float(side) / (2.0 * layerSize(layer));
    texel = vec4(0.5 * baked.r, baked.g, 0.5 + 0.5 * clamp(slope, -1.0, 1.0));
}
