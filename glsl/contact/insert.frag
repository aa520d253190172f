#include "contact/grid.glsl"

flat in int number;
flat in int class_;

layout(location = 0) out vec4 largest;   // blended by MAX
layout(location = 1) out vec4 smallest;  // by MIN
layout(location = 2) out vec4 count;     // by addition

void main() {
    largest = vec4(0.0);
    smallest = vec4(kNobody);
    count = vec4(0.0);
    largest[class_] = smallest[class_] = float(number);
    count[class_] = 1.0;
}
