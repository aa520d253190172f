// Lines of constant width on the screen, drawn inside a face.

// Coverage, 0 to 1, of a line `halfWidth` pixels to each side of where `distance` is zero. `distance` must be linear on the face.
float lineCoverage(float distance, float halfWidth) {
    return 1.0 - smoothstep(halfWidth - 0.5, halfWidth + 0.5, abs(distance) / max(fwidth(distance), 1e-6));
}

// Fades lines out where faces are only a few pixels wide, before they merge into black. `place`: 0 to 1 along the face.
float lineStrength(vec2 place) {
    vec2 w = fwidth(place);
    return clamp(0.14 / max(max(w.x, w.y), 1e-6), 0.0, 1.0);
}
