// The code of a display vertex: how it belongs to its cell. Compiles as C++ (src/surface/display_mesh.hpp) and as GLSL.

// Two bits per axis, x lowest: 0 inside the cell's extent, 1 on its low plane, 2 on its high plane. Planes where the body ends
// do not count.
#define SUNDER_DISPLAY_PLANES_BIT 0
// Bit per axis: the point lies on the body's outside for that axis, and stays there.
#define SUNDER_DISPLAY_OUTSIDE_BIT 6
// Bit per axis: on which side of its plane the point lies at rest, 1: the high one.
#define SUNDER_DISPLAY_SIDE_BIT 9
// Three bits: the face of the cell that this vertex is part of, 2 * axis + (1: the high one).
#define SUNDER_DISPLAY_FACE_BIT 12
#define SUNDER_DISPLAY_FACE_INNER 32768u     // beyond the face is another cell
#define SUNDER_DISPLAY_FACE_BOUNDARY 65536u  // and another cluster

// Share of a cell's edge by which cells that have come apart draw back from each other.
#define SUNDER_DISPLAY_GAP 0.008f
