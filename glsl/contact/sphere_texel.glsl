// Fragments as spheres: the texel a fragment fills is the number of its sphere.
#include "contact/sphere.glsl"

int fragmentSphere() { return (int(gl_FragCoord.y) << (textureShift + SPHERE_BITS)) + int(gl_FragCoord.x); }
