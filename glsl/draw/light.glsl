// How surfaces outdoors answer light: sun with its shadow, sky, and what the ground throws back. Diffuse light is Lambert's; the
// sun's highlight is the GGX microfacet model (Walter et al. 2007) with Smith's masking as Hammon (2017) simplifies it, and
// Schlick's Fresnel term.
#include "draw/sky.glsl"
#include "draw/shadow.glsl"

uniform bool grounded;  // a floor at y = 0

struct Reflector {
    vec3 albedo;      // linear RGB
    float roughness;  // 0 to 1; its square is GGX's α
    float specular;   // share mirrored when seen from straight in front
    float open;       // share of the sky that its own relief leaves visible, 0 to 1
};

float fresnel(float specular, float cosine) {
    return specular + (1.0 - specular) * pow(1.0 - clamp(cosine, 0.0, 1.0), 5.0);
}

// What the sky and the ground throw onto a surface with the unit normal n at height y.
vec3 ambientAt(float y, vec3 n) {
    vec3 ambient = skyLight(n);
    // Close to the floor half of the sky is hidden: that things stand on it shows even in the shade.
    if (grounded) ambient *= 1.0 - 0.5 * exp(-8.0 * max(y, 0.0));
    return ambient;
}

// All light on a point p of a dull surface with the unit normal n.
vec3 diffuseLight(vec3 p, vec3 n) {
    float cosine = dot(n, SUN_DIRECTION);
    float sun = cosine > 0.0 ? cosine * sunVisibility(p, n, cosine) : 0.0;
    return SUN_LIGHT * sun + ambientAt(p.y, n);
}

// The sun's highlight over its light, for unit vectors.
float sunHighlight(float roughness, float specular, vec3 n, vec3 view) {
    vec3 halfway = normalize(SUN_DIRECTION + view);
    float nl = max(dot(n, SUN_DIRECTION), 0.0), nv = max(dot(n, view), 1e-3), nh = max(dot(n, halfway), 0.0);
    float alpha = max(roughness * roughness, 1e-3);
    float d = nh * nh * (alpha * alpha - 1.0) + 1.0;
    float distribution = alpha * alpha / (d * d);  // times π, which SUN_LIGHT leaves out
    float visibility = 0.5 / max(mix(2.0 * nl * nv, nl + nv, alpha), 1e-4);
    return distribution * visibility * nl * fresnel(specular, dot(halfway, view));
}

// Light towards the unit vector `view` from a point p with the geometric normal `face` and the normal n of its relief.
// `mirrored` is what it would mirror were it smooth.
vec3 reflected(Reflector r, vec3 p, vec3 face, vec3 n, vec3 view, vec3 mirrored) {
    float cosine = dot(face, SUN_DIRECTION);
    float sun = cosine > 0.0 ? sunVisibility(p, face, cosine) : 0.0;
    vec3 ambient = r.open * ambientAt(p.y, n);
    vec3 diffuse = r.albedo * (SUN_LIGHT * sun * max(dot(n, SUN_DIRECTION), 0.0) + ambient);
    vec3 highlight = SUN_LIGHT * sun * sunHighlight(r.roughness, r.specular, n, view);
    // Fresnel's rise at the edges is weaker on rough surfaces (Lagarde 2011).
    float nv = max(dot(n, view), 0.0), rise = max(1.0 - r.roughness, r.specular) - r.specular;
    return diffuse + highlight + r.open * (r.specular + rise * pow(1.0 - nv, 5.0)) * mirrored;
}
