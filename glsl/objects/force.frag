// Blended: what objects give a cell, a layer per corner.
in CellForces {
    flat vec3 force[8];  // N
    flat int cell;
} given;
layout(location = 0) out vec4 forces[8];

void main() {
    for (int corner = 0; corner < 8; ++corner) forces[corner] = vec4(given.force[corner], 0.0);
}
