// Edges of the displayed triangles, drawn as lines by the polygon mode.
uniform vec4 lineColour;

out vec4 colour;

void main() {
    colour = lineColour;
}
