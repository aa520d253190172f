#include "draw/sky.glsl"

in vec3 direction;
out vec4 colour;

void main() {
    colour = vec4(skyColour(normalize(direction)), 1.0);
}
