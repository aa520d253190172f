// Object search: a list entry for every cell and object that may touch.
layout(points) in;
layout(points, max_vertices = 8) out;

flat in int cell[];
flat in uvec2 near[];
flat in int nearCount[];

flat out ivec4 pair;  // cell; objects of this cell, plus one, a byte each, in two numbers; which of them this entry is for

void main() {
    for (int slot = 0; slot < min(nearCount[0], 8); ++slot) {
        gl_Position = vec4(0.0);
        pair = ivec4(cell[0], ivec2(near[0]), slot);
        EmitVertex();
        EndPrimitive();
    }
}
