// Blended, in the order of the cells: what cells give an object.
flat in vec3 linear;
flat in vec3 angular;
layout(location = 0) out vec4 impulses[2];

void main() {
    impulses[0] = vec4(linear, 0.0);
    impulses[1] = vec4(angular, 0.0);
}
