uniform int side;  // texels along an edge of what is drawn

// Noise that repeats, for textures that are to be laid side by side. `p` counts lattice cells and `period` says after how many
// of them the noise begins again; `stream` tells noises apart.

// Two numbers in [0, 1) for a lattice cell.
vec2 cellRandom(ivec2 cell, ivec2 period, int stream) {
    cell -= period * ivec2(floor(vec2(cell) / vec2(period)));
    uint h = uint(cell.x + 4099 * cell.y + 1000003 * stream) * 0x9e3779b1u;
    h = (h ^ (h >> 15)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    h ^= h >> 16;
    return vec2(h & 0xffffu, h >> 16) / 65536.0;
}

// Smooth noise from -1 to 1 (Perlin's, with gradients).
float noise(vec2 p, ivec2 period, int stream) {
    vec2 base = floor(p), t = p - base;
    ivec2 cell = ivec2(base);
    vec4 g;
    for (int corner = 0; corner < 4; ++corner) {
        ivec2 at = ivec2(corner & 1, corner >> 1);
        g[corner] = dot(2.0 * cellRandom(cell + at, period, stream) - 1.0, t - vec2(at));
    }
    t = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    return 1.5 * mix(mix(g.x, g.y, t.x), mix(g.z, g.w, t.x), t.y);
}

// Octaves of noise, each twice as fine and half as strong, about -1 to 1. `uv`: 0 to 1 over the texture.
// `side` is never the smaller one; a constant bound would be unrolled, and compiling take twice as long as drawing.
float octaves(vec2 uv, ivec2 period, int count, int stream) {
    float sum = 0.0, weight = 0.5;
    for (int i = 0; i < min(count, side); ++i, period *= 2, weight *= 0.5) sum += weight * noise(uv * vec2(period), period, stream + i);
    return sum;
}

struct Pebble {
    float distance;  // to the middle of the nearest one, in lattice cells
    float edge;      // how much further the second nearest is
    vec2 random;     // of the nearest one
};

// One point per lattice cell, somewhere in it (Worley 1996).
Pebble pebbleAt(vec2 uv, ivec2 period, int stream) {
    vec2 p = uv * vec2(period);
    ivec2 cell = ivec2(floor(p));
    Pebble pebble = Pebble(8.0, 8.0, vec2(0.0));
    float second = 8.0;
    for (int i = 0; i < min(9, side); ++i) {
        ivec2 c = cell + ivec2(i % 3 - 1, i / 3 - 1);
        vec2 random = cellRandom(c, period, stream);
        float d = length(vec2(c) + 0.15 + 0.7 * random - p);
        second = min(second, max(d, pebble.distance));
        if (d < pebble.distance) {
            pebble.distance = d;
            pebble.random = fract(random * 17.0 + 0.31);
        }
    }
    pebble.edge = second - pebble.distance;
    return pebble;
}
