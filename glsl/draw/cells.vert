// One point per face of a cell (thesis, figure 6.6, has one per cell): finds out whether the face is to be seen; the geometry
// shader makes it. On llvmpipe, six points of four vertices each are as quick as one of up to 24 for a whole wall, and a seventh
// quicker for a shattered one.
#include "draw/looks.glsl"

uniform usamplerBuffer cells;
uniform samplerBuffer bodies;
uniform samplerBuffer damage;  // of the bonds that each cell owns
uniform int damageStride;      // texels from one cell's to the next

flat out int cell;
flat out int face;           // 2·axis + side, side 1 on the positive side; −1: nothing to be seen
flat out uint law;
flat out ivec4 lattice;      // the cell's coordinates in its body; the body
flat out uint parity_;       // of i + j + k: which of the two splits into tetrahedra
flat out uint inside;        // 1 on a face that a broken bond has bared
flat out uint crackedEdges;  // bit per edge, at the − and + end of the next axis and of the one after it: beyond it the
                             // same face goes on, but the bond with that cell is broken

const int HOLDS = 0, BROKEN = 1, NO_NEIGHBOUR = 2;

uint lawOf(int c) {
    return texelFetch(cells, c).r & SUNDER_CELL_LAW;
}

// What is between cell `c`, at `place` on a lattice of `size` cells, and its neighbour beyond face `f`.
int bondBeyond(int f, int c, ivec3 place, ivec3 size) {
    int axis = f >> 1;
    bool positive = (f & 1) == 1;
    if (place[axis] == (positive ? size[axis] - 1 : 0)) return NO_NEIGHBOUR;
    int stride = axis == 0 ? 1 : axis == 1 ? size.x : size.x * size.y;
    int neighbour = positive ? c + stride : c - stride;
    if (texelFetch(damage, damageStride * (positive ? c : neighbour))[axis] < 1.0) return HOLDS;
    return lawOf(neighbour) == SUNDER_ABSENT ? NO_NEIGHBOUR : BROKEN;
}

// Lines are drawn of everything; otherwise transparent materials have a pass of their own.
bool drawnHere(uint l) {
#if defined(LINES)
    return true;
#elif defined(TRANSPARENT)
    return looks[l].finish.z > 0.0;
#else
    return looks[l].finish.z == 0.0;
#endif
}

void main() {
    cell = gl_VertexID / 6;
    face = -1;
    law = lawOf(cell);
    lattice = ivec4(0);
    parity_ = inside = crackedEdges = 0u;
    if (law == SUNDER_ABSENT || !drawnHere(law)) return;
    if (texelFetch(damage, damageStride * cell).w == SUNDER_GONE) return;

    int body = int(texelFetch(cells, cell).g);
    ivec4 cellsOfBody = ivec4(texelFetch(bodies, SUNDER_BODY_TEXELS * body));
    ivec3 size = cellsOfBody.xyz;
    int local = cell - cellsOfBody.w;
    ivec3 place = ivec3(local % size.x, (local / size.x) % size.y, local / (size.x * size.y));
    lattice = ivec4(place, body);

    int f = gl_VertexID % 6;
    int bond = bondBeyond(f, cell, place, size);
    if (bond == HOLDS) return;
    face = f;
    parity_ = uint(place.x + place.y + place.z) & 1u;
    inside = bond == BROKEN ? 1u : 0u;
    for (int edge = 0; edge < 4; ++edge) {
        int axis = ((f >> 1) + 1 + (edge >> 1)) % 3;
        if (bondBeyond(2 * axis + (edge & 1), cell, place, size) == BROKEN) crackedEdges |= 1u << uint(edge);
    }
}
