// Edges of the display mesh's triangles, drawn as lines by the polygon mode.
#include "draw/paint.glsl"

flat in int paintedCell;

out vec4 colour;

void main() {
    colour = vec4(paint(paintedCell, vec3(0.02)), 0.28);
}
