// Contact forces: one point per cell.
flat out int cellIndex;

void main() { cellIndex = gl_VertexID; }
