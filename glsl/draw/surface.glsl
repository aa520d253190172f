// Surfaces of bodies: the colour that a material has at a place of its rest frame, inside and outside, with light on it.
// A program with TRANSPARENT defined shades the materials that let light through, any other program the rest.
#include "draw/light.glsl"
#include "draw/looks.glsl"

struct SurfacePoint {
    vec3 position;   // m, world
    vec3 normal;     // unit, world, geometric, towards the viewer's side
    vec3 place;      // m, in the body's rest frame from its low corner: textures hang on it
    uint law;        // row of the table of looks
    float inside;    // 0 on the body's outside, 1 on faces bared by a break
    float boundary;  // 1 on a bared face between two clusters (mortar, the side of a plank), else 0
    float seed;      // 0 to 1, per body: two walls of one material do not look the same
};

#ifdef TRANSPARENT
#include "draw/glass.glsl"
#else
#include "draw/solid.glsl"
#endif

// Linear RGB after light, before the tone curve, and opacity: what it hides of the light behind. The light is its own, already
// weakened by its opacity.
vec4 shade(SurfacePoint s, vec3 eye) {
    vec3 view = normalize(eye - s.position);
#ifdef TRANSPARENT
    return glass(s, looks[s.law], view);
#else
    return vec4(solid(s, looks[s.law], view), 1.0);
#endif
}
