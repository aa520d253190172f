// Buffer layouts and constants that C++ and GLSL both use. Compiles as either: in C++ it is included inside
// namespace sunder::gpu (src/gpu/layout.hpp), where vec4 and uvec4 are glm's.

#define SUNDER_MAX_ELEMENT_LAWS 256
// Cells to a work group of a compute shader.
#define SUNDER_CELL_GROUP 64
// Cell record, four unsigned integers: the bits below; body; mass of a corner (kg) and
// contact damping, as bits of floats.
#define SUNDER_CELL_LAW 511u      // row of the table of laws, or SUNDER_ABSENT
#define SUNDER_ABSENT 511u        // no cell here
#define SUNDER_CELL_ODD 512u      // i + j + k is odd: the mirrored split into tetrahedra
#define SUNDER_CELL_SIDES_BIT 10  // six bits: the body ends on the cell's -x, -y, -z, +x, +y, +z side
#define SUNDER_CELL_ANCHORS_BIT 16  // eight bits: corners that do not move
#define SUNDER_CELL_RESTITUTION_BIT 24  // eight bits: restitution of its material, of 255
// Damage of a bond that never was; a bond holds while its damage is below 1.
#define SUNDER_NO_BOND 2.0
// Stands for "never": no stress reaches it.
#define SUNDER_UNBREAKABLE 1.0e30
// m. Stands for "nowhere": a barrier that nothing comes to.
#define SUNDER_NO_BARRIER 1.0e30

// A block of cells (src/gpu/block_plan.hpp): four texels of the texture buffer `blocks` (RGBA32I).
struct BlockRecord {
    ivec4 origin;  // xyz: its first cell, on the lattice of a body; w: that body
    ivec4 size;    // xyz: cells along x, y, z; w unused
    ivec4 first;   // xyz: the first cell that it owns, in the block; w unused
    ivec4 end;     // xyz: the first beyond those; w unused
};
#define SUNDER_BLOCK_TEXELS 4

#define SUNDER_LAW_GREEN 0.0
#define SUNDER_LAW_COROTATED 1.0

// One row of the uniform block ElementLaws (std140): a material on cells of one size, at the world's step.
struct ElementLaw {
    vec4 cellSize;   // xyz: m; w: volume of a cell, m³
    vec4 elasticity; // λ, μ (Pa); law; S = √(E/E_eff)
    vec4 fracture;   // maxStress (Pa); 1/τ (1/s); shear weight β; internal friction μ
    vec4 extremes;   // viscosity of strongly deformed elements, Pa·s; largest |P| by Green's law, Pa; what a blow may add to a
                     // traction, Pa; w unused
};

// What a row's material looks like: the same row of the uniform block SurfaceLooks (std140; src/render/look_table.hpp).
struct SurfaceLook {
    vec4 outside;   // linear RGB; w unused
    vec4 inside;    // linear RGB of what a break bares; w unused
    vec4 clusters;  // xyz: size, m, 0: through the whole body; w: SUNDER_CLUSTERS_…
    vec4 finish;    // SUNDER_SURFACE_…; joint width, m; transparency, 0 to 1; w unused
};

// Numbered as SurfaceKind in src/core/material.hpp.
#define SUNDER_SURFACE_PLAIN 0
#define SUNDER_SURFACE_WOOD 1
#define SUNDER_SURFACE_BRICK 2
#define SUNDER_SURFACE_CONCRETE 3
#define SUNDER_SURFACE_RUBBER 4
#define SUNDER_SURFACE_GLASS 5

// Clusters with boundaries that can be seen.
#define SUNDER_CLUSTERS_NONE 0
#define SUNDER_CLUSTERS_RUNNING_BOND 1
#define SUNDER_CLUSTERS_PLANKS 2
#define SUNDER_CLUSTERS_BOARDS 3  // planks glued to one another: to be seen, but nothing comes apart there

// One body: seven texels of the texture buffer `bodies` (RGBA32F; integers are exact below 2^24).
struct BodyRecord {
    vec4 lattice;  // cells along x, y, z; first cell
    vec4 cellSize; // xyz: m, along its own axes; w unused
    vec4 gravity;  // xyz: m/s²; w: exp(−drag·h)
    vec4 spheres;  // of a cell: how many along x, y, z: x + 16 y + 256 z; their radius, m; zw unused
    vec4 axisX;    // xyz: its own axes in the world, at rest; w unused
    vec4 axisY;
    vec4 axisZ;
};
#define SUNDER_BODY_TEXELS 7
#define SUNDER_BODY_AXES 4  // texel of the first

// Two bodies that overlap as the world begins (src/core/overlap.hpp): six texels of the texture buffer `partings` (RGBA32F), by a,
// then b.
struct PartingRecord {
    vec4 low;    // xyz: m, along the axes below; w: body a
    vec4 high;   // xyz: likewise; w: body b, greater than a
    vec4 way;    // xyz: unit vector, in the world; w unused
    vec4 axisX;  // xyz: unit vector, in the world; w unused
    vec4 axisY;
    vec4 axisZ;
};
#define SUNDER_PARTING_TEXELS 6

// One event: three texels of the texture buffer `events` (RGBA32F). Before all of them, a texel for the events of every body, then one
// for each body: the first of its events' texels, and how many events it has.
struct EventRecord {
    vec4 patch_;       // xyz: centre, m; w: radius, m
    vec4 acceleration; // xyz: m/s²; w: m/s² away from the centre
    vec4 time;         // start, end in steps from the start of this frame; 1: it lessens towards the rim; w unused
};
#define SUNDER_EVENT_TEXELS 3

// One object (src/core/object.hpp): five texels of the texture buffer `objects` (RGBA32F).
struct ObjectRecord {
    vec4 shape;     // xyz: half the edges of its core, m; w: radius, m
    vec4 inertia;   // xyz: 1/(kg·m²), about its own axes; w: 1/kg; 0: fixed
    vec4 surface;   // friction; restitution; exp(−drag·h); length of its chain, m, 0: none
    vec4 hungFrom;  // xyz: m; w unused
    vec4 colour;    // xyz: linear RGB; w unused
};
#define SUNDER_OBJECT_TEXELS 5

// An object's state: five texels, in layers of a texture.
struct ObjectMotion {
    vec4 position;         // xyz: m; w: 1, or 0: not there
    vec4 orientation;      // quaternion; w: its real part
    vec4 velocity;         // xyz: m/s; w: 0
    vec4 angularMomentum;  // xyz: kg·m²/s, about its centre; w: energy of the spin, J
    vec4 memory;           // load, kg; since it was last looked at: its fastest, m/s; what it had (SUNDER_TOUCHED + SUNDER_HUNG); w: 0
};
#define SUNDER_OBJECT_LAYERS 5
#define SUNDER_TOUCHED 1  // a touch with anything
#define SUNDER_HUNG 2     // a taut chain

// One node in a node buffer, as transform feedback writes it: 8 floats.
struct NodeRecord {
    vec4 displacement; // xyz: m from rest; w: rest height, m, carried along for the ground
    vec4 velocity;     // xyz: m/s; w: 0
};

// One cell in a bond buffer: two texels, or two layers of a texture.
struct BondRecord {
    vec4 damage; // of the bonds through the +x, +y, +z faces; w: 0, or SUNDER_GONE where the body is not there
    vec4 slow;   // slow part of their tractions, Pa; w: of the cell's largest principal stress
};

#define SUNDER_GONE (-1.0)

// One cell's joints, written whenever bonds may have broken: three texels, or three layers of a texture.
struct LinkRecord {
    vec4 masks;            // link masks of corners 0 and 1 (mask 0 + 256 * mask 1), of 2 and 3, 4 and 5, 6 and 7
    vec4 inverseMassLow;   // 1/kg of the groups that corners 0-3 belong to; 0 where anchored or no cell is
    vec4 inverseMassHigh;  // of corners 4-7
};
#define SUNDER_LINK_TEXELS 3

// Texels per tetrahedron in the scatter solver's stress texture (glsl/scatter/textures.glsl).
#define SUNDER_STRESS_TEXELS 3
