// Opaque surfaces, part of draw/surface.glsl: textures sampled along the rest frame's axes, computed joints.
#include "draw/joints.glsl"
#include "draw/surface_layers.glsl"

// How a face lies in the rest frame: seen along its dominant axis, with coordinates u and v (m) on it.
struct Chart {
    int axis;
    vec3 place;              // m, rest frame, a hair inside the face
    vec2 uv, uvAcross, uvUp; // m, with derivatives along the screen
    vec3 alongU, alongV;     // 1, world: gradients of u and v along the surface
};

// x, y or z axes of u and v. Wood has its grain along v wherever that is possible.
vec2 coordinatesOn(int axis, vec3 p) {
    return axis == 0 ? p.zy : axis == 1 ? p.xz : p.xy;
}

// Gradients of u and v come from derivatives (Schüler's cotangent frame, 2013): right on any deformed surface, without
// tangents at vertices. Faces lie exactly where bricks and planks meet, at a wall's edges too, and there rounding would decide
// for each pixel which one it belongs to: what a place is made of is asked a hair inside, where it is the one that the face bounds.
Chart chartOf(SurfacePoint s) {
    vec3 px = dFdx(s.position), py = dFdy(s.position), rx = dFdx(s.place), ry = dFdy(s.place);
    vec3 rest = cross(rx, ry);
    if (dot(cross(px, py), s.normal) < 0.0) rest = -rest;
    vec3 size = abs(rest);
    Chart chart;
    chart.axis = size.x > max(size.y, size.z) ? 0 : size.y > size.z ? 1 : 2;
    const float HAIR = 1e-3;  // m
    chart.place = s.place - HAIR * rest / max(length(rest), 1e-30);
    chart.uv = coordinatesOn(chart.axis, chart.place);
    chart.uvAcross = coordinatesOn(chart.axis, rx);
    chart.uvUp = coordinatesOn(chart.axis, ry);
    vec3 across = cross(py, s.normal), up = cross(s.normal, px);
    float area = dot(px, across);
    float scale = abs(area) > 1e-20 ? 1.0 / area : 0.0;
    chart.alongU = (across * chart.uvAcross.x + up * chart.uvUp.x) * scale;
    chart.alongV = (across * chart.uvAcross.y + up * chart.uvUp.y) * scale;
    return chart;
}

// Four numbers in [0, 1) for a brick or plank of a body (PCG, Jarzynski and Olano 2020).
vec4 clusterRandom(ivec3 cluster, float seed) {
    uvec4 h = uvec4(uvec3(cluster + 4096), uint(seed * 65535.0));
    h = h * 1664525u + 1013904223u;
    h.x += h.y * h.w; h.y += h.z * h.x; h.z += h.x * h.y; h.w += h.y * h.z;
    h ^= h >> 16u;
    h.x += h.y * h.w; h.y += h.z * h.x; h.z += h.x * h.y; h.w += h.y * h.z;
    return vec4(h >> 8u) / 16777216.0;
}

// What a place is made of, before its texture.
struct Finish {
    vec3 colour;      // linear RGB
    int layer;        // of the surface textures; -1: none
    float relief;     // factor on the texture's slopes
    float contrast;   // factor on its differences of brightness
    float warmth;     // how much redder dark spots are
    float stain;      // how much wide patches differ in brightness
};

Finish finishOf(int kind, SurfaceLook look, SurfacePoint s, int axis) {
    bool inside = s.inside > 0.5, boundary = s.boundary > 0.5;
    Finish f = Finish(inside ? look.inside.rgb : look.outside.rgb, -1, 1.0, 1.0, 0.0, 0.0);
    if (kind == SUNDER_SURFACE_WOOD) {
        f.layer = axis == 1 ? SUNDER_LAYER_WOOD_END : inside && !boundary ? SUNDER_LAYER_WOOD_SPLIT : SUNDER_LAYER_WOOD;
        f.warmth = 0.3;
        f.stain = 0.25;
    } else if (kind == SUNDER_SURFACE_BRICK) {
        f.layer = inside ? SUNDER_LAYER_BRICK_SPLIT : SUNDER_LAYER_BRICK;
        f.stain = 0.35;
    } else if (kind == SUNDER_SURFACE_CONCRETE) {
        f.layer = inside ? SUNDER_LAYER_CONCRETE_SPLIT : SUNDER_LAYER_CONCRETE;
        f.warmth = inside ? 0.0 : 0.08;
        f.stain = 0.38;
    } else if (kind == SUNDER_SURFACE_RUBBER) {
        f.layer = SUNDER_LAYER_RUBBER;
        f.relief = inside ? 3.0 : 1.0;
        f.contrast = inside ? 2.0 : 1.0;
    }
    return f;
}

const vec3 MORTAR = vec3(0.37, 0.35, 0.32);  // linear RGB

vec3 solid(SurfacePoint s, SurfaceLook look, vec3 view) {
    Chart chart = chartOf(s);
    int kind = int(look.finish.x);
    Finish finish = finishOf(kind, look, s, chart.axis);

    vec4 random = clusterRandom(clusterAt(look, chart.place), s.seed);
    vec3 footprint = abs(dFdx(s.place)) + abs(dFdy(s.place));

    vec2 size = layerSize(finish.layer);
    vec2 uv = chart.uv / size, across = chart.uvAcross / size, up = chart.uvUp / size;
    float layer = float(surfaceLayers[max(finish.layer, 0)]);
    float wide = wideVariation(chart.uv + 5.0 * s.seed, chart.uvAcross, chart.uvUp);
    bool mortared = kind == SUNDER_SURFACE_BRICK;
    // The same pattern, finer: the ragged edges of bricks, and what mortar stays on a bared one.
    float ragged = mortared ? wideVariation(9.0 * chart.uv.yx, 9.0 * chart.uvAcross.yx, 9.0 * chart.uvUp.yx) - 1.0 : 0.0;
    bool clustered = int(look.clusters.w) != SUNDER_CLUSTERS_NONE;
    Joint joint = Joint(0.0, vec3(0.0));
    if (clustered) joint = jointAt(look, chart.place, footprint, chart.axis, 0.005 * ragged);
    if (s.boundary > 0.5) joint = Joint(mortared ? smoothstep(-0.3, -0.05, ragged) : 0.0, vec3(0.0));
    if (mortared && joint.coverage > 0.5) layer = float(surfaceLayers[SUNDER_LAYER_MORTAR]);
    vec4 texel = textureGrad(surfaces, vec3(uv + random.xy, layer), across, up);
    if (finish.layer < 0) {
        texel = vec4(0.5, 0.6, 0.5, 0.5);
    }

    float brightness = 1.0 + finish.contrast * (2.0 * texel.r - 1.0);
    brightness *= 1.0 + finish.stain * (wide - 1.0);
    vec3 colour = finish.colour;
    if (int(look.clusters.w) != SUNDER_CLUSTERS_NONE) {
        float spread = kind == SUNDER_SURFACE_BRICK ? 0.5 : 0.3;
        colour *= (1.0 + spread * (random.z - 0.5)) * vec3(1.0, 1.0 + 0.25 * (random.w - 0.5), 1.0 + 0.35 * (random.w - 0.5));
    }
    colour *= brightness * (1.0 - finish.warmth * (brightness - 1.0) * vec3(1.0, 0.0, -1.0));
    // Mortar is of its own colour; a groove only is dark.
    vec3 filling = mortared ? MORTAR * 2.0 * texel.r : 0.3 * colour;
    float mortar = int(look.clusters.w) == SUNDER_CLUSTERS_NONE ? 0.0 : joint.coverage;

    vec2 slope = finish.relief * (2.0 * texel.ba - 1.0) + coordinatesOn(chart.axis, joint.slope);
    vec3 n = normalize(s.normal - slope.x * chart.alongU - slope.y * chart.alongV);
    float open = 1.0 - 0.35 * mortar;
    Reflector reflector = Reflector(max(mix(colour, filling, mortar), vec3(0.0)), mix(texel.g, 0.9, mortar), 0.04, open);
    vec3 mirrored = ambientAt(s.position.y, reflect(-view, n));
    return reflected(reflector, s.position, s.normal, n, view, mirrored);
}
