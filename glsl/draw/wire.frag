// Edges of faces, drawn as lines by the polygon mode. Those of faces that look away stay visible, but faint.
#include "draw/paint.glsl"

uniform vec3 eye;

in vec3 position;
flat in vec3 normal;
flat in vec3 baseColour;  // linear RGB
flat in int paintedCell;

out vec4 colour;

void main() {
    // Not gl_FrontFacing: behind a geometry shader, with polygons drawn as lines, Mesa 22.3's llvmpipe then draws garbage.
    bool front = dot(normal, eye - position) > 0.0;
    colour = vec4(paint(paintedCell, baseColour * 0.14), front ? 0.9 : 0.2);
}
