// Draws a point into the force texture (alpha masked: it holds the inverse mass) and the stress texture, both blended by addition.
in vec4 combinedForce;
layout(location = 0) out vec4 forceTarget;
#if FRACTURE
in vec4 combinedStress;
layout(location = 1) out vec4 stressTarget;
#endif

void main() {
    forceTarget = combinedForce;
#if FRACTURE
    stressTarget = combinedStress;
#endif
}
