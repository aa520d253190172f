// Cells and objects that may touch, as they were listed: captured again when a saved state is restored.
in ivec4 listed;

flat out ivec4 pair;  // objects/search.geom

void main() {
    gl_Position = vec4(0.0);
    pair = listed;
}
