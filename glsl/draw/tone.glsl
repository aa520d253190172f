// The tone curve of everything that is drawn: a film's, with a soft shoulder, so that no white burns out, and a short toe.

// Linear RGB of light to linear RGB of the screen, 0 to 1; for each channel x(ax + b)/(x(ax + c) + d).
vec3 toneCurve(vec3 light) {
    const float EXPOSURE = 0.8, A = 2.4, B = 0.12, C = 0.62, D = 0.17;
    vec3 x = EXPOSURE * max(light, vec3(0.0));
    return x * (A * x + B) / (x * (A * x + C) + D);
}
