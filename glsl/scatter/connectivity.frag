in vec4 cumulative;
layout(location = 0) out vec4 cumulativeTarget;

void main() { cumulativeTarget = cumulative; }
