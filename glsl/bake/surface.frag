// Draws the layer LAYER of the surface textures (draw/surface_layers.glsl): brightness, roughness and height, from which
// bake/slopes.frag makes the texture.
#include "draw/surface_layers.glsl"
#include "bake/noise.glsl"

struct Bake {
    float brightness;  // factor on the material's colour, 0 to 2
    float roughness;   // 0 to 1
    float height;      // m
};

out vec4 baked;

// From early wood to the dark late wood at the end of a year, for a growth phase in years.
float lateWood(float phase) {
    float t = fract(phase);
    return smoothstep(0.25, 0.85, t) * (1.0 - smoothstep(0.92, 1.0, t));
}

// A board sawn beside the middle of the trunk: growth lines along it that bend around a few knots.
Bake wood(vec2 uv) {
    float phase = 22.0 * uv.x + 2.2 * octaves(uv, ivec2(3, 2), 3, 1);
    float knots = 0.0;
    for (int i = 0; i < 2; ++i) {
        vec2 at = cellRandom(ivec2(i, 0), ivec2(64), 40);
        vec2 d = abs(uv - at);
        d = min(d, 1.0 - d) / vec2(0.085, 0.05);
        phase += 5.0 * exp(-dot(d, d));
        knots = max(knots, smoothstep(0.5, 0.12, length(d)));
    }
    float late = lateWood(phase);
    float fibre = noise(uv * vec2(128, 6), ivec2(128, 6), 10) + 0.6 * noise(uv * vec2(256, 16), ivec2(256, 16), 11);
    float pores = smoothstep(0.42, 0.75, noise(uv * vec2(160, 12), ivec2(160, 12), 12));
    float streaks = noise(uv * vec2(9, 1), ivec2(9, 1), 13);
    Bake b;
    b.brightness = 1.10 - 0.30 * late + 0.07 * fibre - 0.22 * pores + 0.12 * streaks - 0.55 * knots;
    b.roughness = 0.56 + 0.10 * late + 0.15 * pores;
    b.height = 1e-3 * (0.12 * late + 0.07 * fibre - 0.25 * pores - 0.2 * knots);
    return b;
}

// Torn along the grain: pale, with strands that stand up.
Bake woodSplit(vec2 uv) {
    float bend = 0.012 * noise(uv * vec2(4, 3), ivec2(4, 3), 1);
    vec2 p = uv + vec2(bend, 0.0);
    float strands = noise(p * vec2(40, 3), ivec2(40, 3), 2) + 0.6 * noise(p * vec2(96, 6), ivec2(96, 6), 3) +
                    0.4 * noise(p * vec2(224, 10), ivec2(224, 10), 4);
    float late = lateWood(22.0 * p.x + 1.5 * octaves(p, ivec2(3, 2), 2, 5));
    float ends = noise(p * vec2(96, 24), ivec2(96, 24), 6);
    return Bake(1.0 + 0.20 * strands - 0.16 * late + 0.06 * ends, 0.82 - 0.08 * strands,
                1e-3 * (1.3 * strands + 0.5 * ends));
}

// Growth rings, wide arcs as a board far from the middle of the trunk has them, and cracks across them.
Bake woodEnd(vec2 uv) {
    float arc = 14.0 * uv.y + 2.0 * cos(6.2831853 * uv.x) + 0.5 * octaves(uv, ivec2(4, 4), 3, 1);
    float late = lateWood(arc);
    float pores = smoothstep(0.2, 0.7, noise(uv * 128.0, ivec2(128), 2));
    float rays = noise(uv * vec2(160, 10), ivec2(160, 10), 3);
    float checks = smoothstep(0.62, 0.85, noise(uv * vec2(20, 3), ivec2(20, 3), 4));
    return Bake(0.86 - 0.26 * late - 0.12 * pores + 0.08 * rays - 0.35 * checks, 0.85,
                1e-3 * (0.25 * late - 0.25 * pores + 0.15 * rays - 0.8 * checks));
}

// Fired clay: blotches of the fire, sand, pits and fine cracks.
Bake brick(vec2 uv) {
    float blotch = octaves(uv, ivec2(5, 5), 4, 1);
    float sand = noise(uv * 160.0, ivec2(160), 6);
    Pebble pit = pebbleAt(uv, ivec2(26), 20);
    float radius = 0.1 + 0.3 * pit.random.y * pit.random.y;
    float pits = pit.random.x < 0.2 ? smoothstep(radius, 0.4 * radius, pit.distance) : 0.0;
    float grain = octaves(uv, ivec2(40, 40), 3, 30);
    return Bake(1.0 + 0.65 * blotch + 0.10 * sand + 0.28 * grain - 0.30 * pits, 0.78 + 0.1 * sand,
                1e-3 * (0.9 * grain + 0.22 * sand - 1.6 * pits + 1.2 * blotch));
}

Bake brickSplit(vec2 uv) {
    float rough = octaves(uv, ivec2(9, 9), 5, 1);
    Pebble grit = pebbleAt(uv, ivec2(48), 20);
    float grain = grit.random.x < 0.25 ? smoothstep(0.45, 0.25, grit.distance) : 0.0;
    return Bake(1.0 + 0.5 * rough + 0.5 * grain * (grit.random.y - 0.45), 0.92,
                1e-3 * (6.0 * rough + 1.0 * grain));
}

Bake mortar(vec2 uv) {
    float sand = noise(uv * 144.0, ivec2(144), 1);
    float lumps = octaves(uv, ivec2(18, 18), 4, 2);
    return Bake(1.0 + 0.13 * sand + 0.30 * lumps, 0.92, 1e-3 * (0.35 * sand + 1.8 * lumps));
}

// Cast against boards of steel: clouds, fine sand, and the holes of air bubbles.
Bake concrete(vec2 uv) {
    float clouds = octaves(uv, ivec2(4, 4), 5, 1);
    float sand = noise(uv * 200.0, ivec2(200), 8) + 0.6 * noise(uv * 90.0, ivec2(90), 9);
    Pebble bubble = pebbleAt(uv, ivec2(30), 20);
    float radius = 0.06 + 0.16 * bubble.random.y;
    float hole = bubble.random.x < 0.22 ? smoothstep(radius, 0.6 * radius, bubble.distance) : 0.0;
    return Bake(1.0 + 0.26 * clouds + 0.07 * sand - 0.42 * hole, 0.80 - 0.1 * clouds,
                1e-3 * (0.22 * sand + 0.8 * clouds - 1.8 * hole));
}

// Broken through: stones of different greys, large ones and small ones between them, in cement.
Bake concreteSplit(vec2 uv) {
    vec2 warp = 0.012 * vec2(noise(uv * 24.0, ivec2(24), 1), noise(uv * 24.0, ivec2(24), 2));
    Pebble large = pebbleAt(uv + warp, ivec2(14), 20), small = pebbleAt(uv + warp, ivec2(34), 21);
    float cement = octaves(uv, ivec2(24, 24), 4, 3);
    float inLarge = large.random.x < 0.72 ? smoothstep(0.0, 0.08, min(large.edge, 0.5 - large.distance)) : 0.0;
    float inSmall = small.random.x < 0.6 ? (1.0 - inLarge) * smoothstep(0.0, 0.12, min(small.edge, 0.42 - small.distance)) : 0.0;
    float brightness = 1.02 + 0.30 * cement;
    brightness = mix(brightness, 0.40 + 1.10 * large.random.y + 0.12 * cement, inLarge);
    brightness = mix(brightness, 0.50 + 0.95 * small.random.y, inSmall);
    float height = 3.0 * cement + inLarge * (4.0 - 9.0 * large.distance * large.distance) + 1.2 * inSmall;
    return Bake(brightness, 0.92 - 0.22 * inLarge, 1e-3 * height);
}

Bake rubber(vec2 uv) {
    float grain = noise(uv * 120.0, ivec2(120), 1);
    float dust = octaves(uv, ivec2(5, 5), 5, 2);
    return Bake(1.0 + 0.14 * grain + 0.22 * dust, 0.52 + 0.25 * dust, 1e-3 * (0.16 * grain + 0.4 * dust));
}

// Brightness is the clouds' density.
Bake clouds(vec2 uv) {
    vec2 warp = 0.05 * vec2(noise(4.0 * uv, ivec2(4), 30), noise(4.0 * uv, ivec2(4), 31));
    return Bake(1.0 + 1.3 * octaves(uv + warp, ivec2(4, 4), 6, 1), 0.0, 0.0);
}

Bake bake(vec2 uv) {
    switch (LAYER) {
        case SUNDER_LAYER_WOOD: return wood(uv);
        case SUNDER_LAYER_WOOD_END: return woodEnd(uv);
        case SUNDER_LAYER_WOOD_SPLIT: return woodSplit(uv);
        case SUNDER_LAYER_BRICK: return brick(uv);
        case SUNDER_LAYER_BRICK_SPLIT: return brickSplit(uv);
        case SUNDER_LAYER_MORTAR: return mortar(uv);
        case SUNDER_LAYER_CONCRETE: return concrete(uv);
        case SUNDER_LAYER_CONCRETE_SPLIT: return concreteSplit(uv);
        case SUNDER_LAYER_RUBBER: return rubber(uv);
        default: return clouds(uv);
    }
}

void main() {
    Bake b = bake(gl_FragCoord.xy / float(side));
    baked = vec4(b.brightness, b.roughness, b.height, 0.0);
}
