// How many barriers and objects an object touches; cells are added by blending. One fragment per object.
#include "objects/among.glsl"

layout(location = 0) out vec4 count;

float touching = 0.0;

void meet(Touch touch, vec3 velocity, int other, bool own, float restitution, float friction) {
    if (touches(touch, velocity, stepSize)) touching += 1.0;
}

void main() {
    meetAll(int(gl_FragCoord.x));
    count = vec4(touching, 0.0, 0.0, 0.0);
}
