flat in float body;
flat in vec3 displacement;

// Blended by MAX.
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;

void main() {
    first = vec4(body, -body, displacement.x, -displacement.x);
    second = vec4(displacement.y, -displacement.y, displacement.z, -displacement.z);
}
