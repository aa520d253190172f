// Blended: how many cells touch an object.
layout(location = 0) out vec4 count;

void main() { count = vec4(1.0, 0.0, 0.0, 0.0); }
