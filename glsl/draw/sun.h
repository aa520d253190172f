// Where the sun stands; compiles as C++ (src/render/shadow_map.cpp, vec3 is glm's) and as GLSL. Towards the sun, any length.
#define SUNDER_SUN_DIRECTION vec3(-0.72, 0.85, 0.48)
