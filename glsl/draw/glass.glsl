// Transparent surfaces, part of draw/surface.glsl.

vec4 glass(SurfacePoint s, SurfaceLook look, vec3 view) {
    float cosine = max(dot(s.normal, view), 0.0);
    // Both of a pane's faces mirror, with every reflection between them.
    float once = fresnel(0.04, cosine);
    float mirror = 2.0 * once / (1.0 + once);
    // A ray that is bent to 1/1.5 of its sine goes a longer way through the pane.
    float way = inversesqrt(1.0 - (1.0 - cosine * cosine) / 2.25);
    float through = (1.0 - mirror) * pow(look.finish.z, way);
    vec3 tint = look.outside.rgb;
    if (s.inside > 0.5) {
        // A broken edge is looked into along the pane: thick glass, which is dark and green.
        through *= 0.35;
        tint = look.inside.rgb;
    }
    float sun = sunVisibility(s.position, s.normal, dot(s.normal, SUN_DIRECTION));
    // Clear glass swallows what it does not let through; little of it comes back.
    vec3 scattered = 0.4 * tint * (ambientAt(s.position.y, s.normal) + 0.4 * SUN_LIGHT * sun);
    vec3 light = mirror * mirroredAt(reflect(-view, s.normal)) + max(1.0 - mirror - through, 0.0) * scattered;
    light += SUN_LIGHT * sun * sunHighlight(0.12, 0.04, s.normal, view);
    return vec4(light, 1.0 - through);
}
