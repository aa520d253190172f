// Edges of the display mesh's triangles, drawn as lines by the polygon mode.
out vec4 colour;

void main() {
    colour = vec4(0.02, 0.02, 0.02, 0.5);
}
