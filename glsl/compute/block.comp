// Several substeps at once of bodies that touch nothing: one work group per block of cells (src/gpu/block_plan.hpp), eight invocations
// per cell. Each has a node, which stays in its registers from the first substep to the last; five of them work out a tetrahedron
// each. Everything else goes from one to another through shared memory. There are many of them so that the code is short: a GPU
// fetches instructions more slowly than it computes.
//
// A block that is part of a body begins with a rim of cells that others own. What it works out for them is wrong from outside inwards,
// by one cell more in each substep, and is never written; what it owns is worked out from the same numbers by the same operations
// wherever it is worked out, and so has the same bits.
#include "gather/node.glsl"
#include "physics/lattice.glsl"
#include "physics/elasticity.glsl"
#include "physics/eigen.glsl"
#include "physics/events.glsl"
#include "physics/integrate.glsl"
#include "physics/joints.glsl"
#include "physics/octants.glsl"
#include "physics/fracture.glsl"

layout(local_size_x = BLOCK_INVOCATIONS) in;
layout(rgba32f) writeonly uniform image2DArray newNodes, newBonds, newLinks;

uniform isamplerBuffer blocks;  // BlockRecord
uniform sampler2DArray links;   // layers of LinkRecord
uniform sampler2DArray bonds;   // layers of BondRecord
uniform samplerBuffer rest;     // xyz: rest position, m
uniform int substeps;
uniform bool pushed;        // an event acts in this frame
uniform float stepInFrame;  // of the first substep
uniform bool newNodeWatch, newBondWatch;  // bodies were looked at for rest just before
uniform int firstLook, lookInterval;      // substeps: until bonds are tested; from one test to the next

// What barrier() makes visible to all, in a work group. Each by number and then cell. What a cell's nodes do, three for each:
// displacements, m, then velocities, m/s; forces on them, N.
shared float motions[48 * BLOCK_CELLS];
shared float forces[24 * BLOCK_CELLS];
// What its tetrahedra do, nine for each: forces, N, at the ends of the edges that the columns of F are made of. Or, where bonds are
// tested, of the corner ones six Biot stresses each, Pa; then the largest principal stress of all five, and the slow part of that.
shared float tetrahedra[45 * BLOCK_CELLS];
const int kPrincipal = 24, kSlowPrincipal = 29;
shared float turnBack[9 * BLOCK_CELLS];  // columns of what turns its forces back
shared uint held[BLOCK_CELLS];           // bonds that it owns and that hold
shared uint broken;                      // whether any broke

int place, slot;  // of the cell, in the block; of the invocation, in the cell
ivec3 size, at;   // cells; of this one, in the block

ivec3 placeSteps() { return ivec3(1, size.x, size.x * size.y); }
int stepsTo(ivec3 offset) {
    ivec3 steps = offset * placeSteps();
    return steps.x + steps.y + steps.z;
}

float principalStress(int of) {
    float largest = tetrahedra[kPrincipal * BLOCK_CELLS + of];
    for (int t = 1; t < 5; ++t) largest = max(largest, tetrahedra[(kPrincipal + t) * BLOCK_CELLS + of]);
    return largest;
}
float slowStress(int of) { return tetrahedra[kSlowPrincipal * BLOCK_CELLS + of]; }
mat3 biot(int of, int tetrahedron) {
    int first = 6 * tetrahedron * BLOCK_CELLS + of;
    float xx = tetrahedra[first], yy = tetrahedra[first + BLOCK_CELLS], zz = tetrahedra[first + 2 * BLOCK_CELLS];
    float xy = tetrahedra[first + 3 * BLOCK_CELLS], yz = tetrahedra[first + 4 * BLOCK_CELLS], zx = tetrahedra[first + 5 * BLOCK_CELLS];
    return mat3(xx, xy, zx, xy, yy, yz, zx, yz, zz);
}
uint heldBy(int cell, ivec3 offset) {
    ivec3 there = at + offset;
    bool within = all(greaterThanEqual(there, ivec3(0))) && all(lessThan(there, size));
    return within ? held[place + stepsTo(offset)] : 0u;
}

// Whole vectors from and to shared memory: an index into one would put it in memory of its own on some GPUs.
vec3 motionAt(int first) { return vec3(motions[first], motions[first + BLOCK_CELLS], motions[first + 2 * BLOCK_CELLS]); }
vec3 stressForce(int first) {
    return vec3(tetrahedra[first], tetrahedra[first + BLOCK_CELLS], tetrahedra[first + 2 * BLOCK_CELLS]);
}
vec3 turnAt(int first) { return vec3(turnBack[first], turnBack[first + BLOCK_CELLS], turnBack[first + 2 * BLOCK_CELLS]); }
void keepMotion(int first, vec3 x) {
    motions[first] = x.x;
    motions[first + BLOCK_CELLS] = x.y;
    motions[first + 2 * BLOCK_CELLS] = x.z;
}
void keepForce(int first, vec3 x) {
    tetrahedra[first] = x.x;
    tetrahedra[first + BLOCK_CELLS] = x.y;
    tetrahedra[first + 2 * BLOCK_CELLS] = x.z;
}
void keepTurn(int first, vec3 x) {
    turnBack[first] = x.x;
    turnBack[first + BLOCK_CELLS] = x.y;
    turnBack[first + 2 * BLOCK_CELLS] = x.z;
}

// A tetrahedron, numbered by slots: the four at corners 1, 2, 4, 7, then the central one.
struct Tetrahedron {
    mat3 F, rate;
    ElementStress stress;
};

// Where a tetrahedron's four nodes are in `motions`, those of the central one in the order of their numbers; of the others, the apex
// first, then its neighbours along x, y, z.
ivec4 ends;

const int kApex[5] = int[5](1, 2, 4, 7, 0);

void findEnds(int mirror) {
    int a = kApex[slot];
    ivec4 corners = slot < 4 ? ivec4(a, a ^ 1, a ^ 2, a ^ 4) : ivec4(0, 3, 5, 6);
    ends = 3 * BLOCK_CELLS * (corners ^ mirror) + place;
}

// As in gather/element.frag, of displacements, or what lies `beyond` them. toward: signed reciprocal edge lengths, 1/m, away from the
// apex; of the central one half of those.
mat3 gradient(int beyond, vec3 toward) {
    vec3 a = motionAt(beyond + ends.x), x = motionAt(beyond + ends.y), y = motionAt(beyond + ends.z), z = motionAt(beyond + ends.w);
    if (slot < 4) return mat3((x - a) * toward.x, (y - a) * toward.y, (z - a) * toward.z);
    return centralGradient(a, x, y, z, toward);
}

Tetrahedron tetrahedron(ElementLaw law, vec3 toward, BodyRecord body, bool look) {
    Tetrahedron t;
    t.F = gradient(0, toward);
    t.rate = gradient(24 * BLOCK_CELLS, toward);
#ifdef TURNED
    mat3 own = transpose(bodyAxes(body));
    t.F = own * t.F;
    t.rate = own * t.rate;
#endif
    t.F += mat3(1.0);
    t.stress = elementStress(law, t.F, t.rate, stepSize, look);
    return t;
}

void keepStress(ElementLaw law, Tetrahedron t) {
#if BONDS_BREAK
    if (slot < 4) {
        mat3 T = biotStress(t.stress);
        int first = 6 * slot * BLOCK_CELLS + place;
        tetrahedra[first] = T[0][0];
        tetrahedra[first + BLOCK_CELLS] = T[1][1];
        tetrahedra[first + 2 * BLOCK_CELLS] = T[2][2];
        tetrahedra[first + 3 * BLOCK_CELLS] = T[0][1];
        tetrahedra[first + 4 * BLOCK_CELLS] = T[1][2];
        tetrahedra[first + 5 * BLOCK_CELLS] = T[2][0];
    }
#endif
#if CELLS_BREAK
    vec3 values = vec3(-1.0e30);
    mat3 vectors;
    if (law.fracture.x < SUNDER_UNBREAKABLE)
        symmetricEigen(scaledCauchyStress(law, t.F, t.stress.piola), values, vectors);
    tetrahedra[(kPrincipal + slot) * BLOCK_CELLS + place] = values.x;
#endif
}

// weights: m²; forces are the columns of P times these.
void keepForces(ElementLaw law, Tetrahedron t, vec3 weights, BodyRecord body) {
    int first = 9 * slot * BLOCK_CELLS + place;
    keepForce(first, t.stress.piola[0] * weights.x);
    keepForce(first + 3 * BLOCK_CELLS, t.stress.piola[1] * weights.y);
    keepForce(first + 6 * BLOCK_CELLS, t.stress.piola[2] * weights.z);
    if (slot == 4) {
        mat3 back = turnedBack(law, t.F, t.rate, stepSize);
#ifdef TURNED
        back = bodyAxes(body) * back;
#endif
        keepTurn(place, back[0]);
        keepTurn(place + 3 * BLOCK_CELLS, back[1]);
        keepTurn(place + 6 * BLOCK_CELLS, back[2]);
    }
}

// Where what pulls at a corner is in `tetrahedra`. A corner is the apex of one and pulled by all its three forces, or one of the base
// of three others, and of the central one.
int pullX, pullY, pullZ;
vec3 side;  // signs of the central one's forces; zero at an apex

int pullOf(int apex, int axis) { return (9 * (apex == 7 ? 3 : apex >> 1) + 3 * axis) * BLOCK_CELLS + place; }

void findPulls(int corner) {
    ivec3 bits = cornerBits(corner);
    bool apex = ((bits.x + bits.y + bits.z) & 1) != 0;
    side = apex ? vec3(0.0) : 2.0 * vec3(bits) - 1.0;
    pullX = pullOf(apex ? corner : corner ^ 1, 0);
    pullY = pullOf(apex ? corner : corner ^ 2, 1);
    pullZ = pullOf(apex ? corner : corner ^ 4, 2);
}

// N.
vec3 cornerForce() {
    vec3 force = stressForce(pullX) + stressForce(pullY) + stressForce(pullZ);
    if (side.x == 0.0) force = -force;
    else {
        int central = 36 * BLOCK_CELLS + place;
        force += side.x * stressForce(central) + side.y * stressForce(central + 3 * BLOCK_CELLS) +
                 side.z * stressForce(central + 6 * BLOCK_CELLS);
    }
    return force.x * turnAt(place) + force.y * turnAt(place + 3 * BLOCK_CELLS) + force.z * turnAt(place + 6 * BLOCK_CELLS);
}

// Force on the joined group of a node: as in gather/node.frag, in the same order for every copy. base: the place of the cell whose
// corner 7 it is; steps: from a place to those next to it.
vec3 groupForce(uint mask, int base, ivec3 steps) {
    vec3 force = vec3(0.0);
    for (int octant = 0; octant < 8; ++octant) {
        int other = base;
        if ((octant & 1) != 0) other += steps.x;
        if ((octant & 2) != 0) other += steps.y;
        if ((octant & 4) != 0) other += steps.z;
        // No branch, or one would wait for memory after the other.
        bool joined = (mask >> uint(octant) & 1u) != 0u;
        int first = 3 * (octant ^ 7) * BLOCK_CELLS + (joined ? other : place);
        vec3 some = vec3(forces[first], forces[first + BLOCK_CELLS], forces[first + 2 * BLOCK_CELLS]);
        force += joined ? some : vec3(0.0);
    }
    return force;
}

void main() {
    place = int(gl_LocalInvocationID.x) % BLOCK_CELLS;
    slot = int(gl_LocalInvocationID.x) / BLOCK_CELLS;
    int block = SUNDER_BLOCK_TEXELS * int(gl_WorkGroupID.x);
    ivec4 origin = texelFetch(blocks, block);
    size = texelFetch(blocks, block + 1).xyz;
    at = ivec3(place % size.x, place / size.x % size.y, place / (size.x * size.y));
    bool inside = at.z < size.z;
    bool owned = inside && all(greaterThanEqual(at, texelFetch(blocks, block + 2).xyz)) &&
                 all(lessThan(at, texelFetch(blocks, block + 3).xyz));
    uint sides = uint(at.x == 0) | uint(at.y == 0) << 1u | uint(at.z == 0) << 2u | uint(at.x == size.x - 1) << 3u |
                 uint(at.y == size.y - 1) << 4u | uint(at.z == size.z - 1) << 5u;
    uint within = octantsWithin(slot, sides);
    BodyRecord body = bodyRecord(origin.w);
    ivec4 lattice = ivec4(body.lattice);
    ivec3 way = (origin.xyz + at) * cellStrides(lattice);
    int cell = inside ? lattice.w + way.x + way.y + way.z : lattice.w;
    ivec2 texel = texelAddress(cell);
    uvec4 record = cellRecord(cell);
    bool there = inside && lawOf(record) != SUNDER_ABSENT, works = there && slot < 5;
    ElementLaw law = laws[there ? lawOf(record) : 0u];
    int mirror = parityOf(record), base = place - stepsTo(cornerBits(slot ^ 7));
    ivec3 steps = placeSteps();
    findEnds(mirror);
    findPulls(slot ^ mirror);
    vec3 toward = (slot < 4 ? 1.0 - 2.0 * vec3(cornerBits(kApex[slot])) : vec3(0.5)) / law.cellSize.xyz;
    if (mirror != 0) toward.x = -toward.x;
    vec3 weights = toward * (law.cellSize.w / (slot < 4 ? -6.0 : -3.0));

    vec4 displacement = texelFetch(nodes, ivec3(texel, displacementLayer(slot)), 0);
    vec4 velocity = texelFetch(nodes, ivec3(texel, velocityLayer(slot)), 0);
    if (newNodeWatch) velocity.w = 0.0;
    Joint joint = Joint(linkMaskOf(texelFetch(links, ivec3(texel, 0), 0), slot),
                        texelFetch(links, ivec3(texel, 1 + slot / 4), 0)[slot & 3]);
    if (!there) joint = Joint(0u, 0.0);
    vec4 damage = vec4(SUNDER_NO_BOND), slow = vec4(0.0);
    if (firstLook < substeps && slot == 0 && there) {
        damage = texelFetch(bonds, ivec3(texel, 0), 0);
        slow = texelFetch(bonds, ivec3(texel, 1), 0);
        if (newBondWatch) damage.w = 0.0;
    }
    // Bonds to cells outside the block: nobody knows their stress.
    bvec3 beyond = equal(at, size - 1);
    int nextLook = firstLook;
    for (int i = 0; i < substeps; ++i) {
        keepMotion(3 * slot * BLOCK_CELLS + place, displacement.xyz);
        keepMotion((24 + 3 * slot) * BLOCK_CELLS + place, velocity.xyz);
        barrier();
        bool look = i == nextLook;
        Tetrahedron t;
        if (works) t = tetrahedron(law, toward, body, look);
        if (look) {
            nextLook += lookInterval;
            if (works) keepStress(law, t);
            if (slot == 0) tetrahedra[kSlowPrincipal * BLOCK_CELLS + place] = slow.w;
            if (gl_LocalInvocationID.x == 0u) broken = 0u;
            barrier();
            if (slot == 0) {
                vec3 d = mix(damage.xyz, vec3(SUNDER_NO_BOND), beyond), before = d;
                if (there) updateBonds(cell, place, steps, d, slow);
                if (any(notEqual(d, before))) damage.w = 1.0;
                if (heldWith(d) != heldWith(before)) broken = 1u;
                damage.xyz = mix(d, damage.xyz, beyond);
                held[place] = heldWith(damage.xyz);
            }
            barrier();
        }
        if (works) keepForces(law, t, weights, body);
        barrier();
        if (there) {
            vec3 force = cornerForce();
            int first = 3 * slot * BLOCK_CELLS + place;
            forces[first] = force.x;
            forces[first + BLOCK_CELLS] = force.y;
            forces[first + 2 * BLOCK_CELLS] = force.z;
        }
        barrier();
        if (joint.inverseMass > 0.0) {  // not anchored, and there is a cell
            vec3 force = groupForce(joint.mask & within, base, steps);
            bool placed = ROOM != 0 || pushed;
            vec3 restPosition = placed ? texelFetch(rest, 8 * cell + slot).xyz : vec3(0.0, displacement.w, 0.0);
            vec3 acceleration = vec3(0.0);
            if (pushed) acceleration = eventAcceleration(origin.w, restPosition, displacement.xyz, stepInFrame + float(i));
            vec3 x = displacement.xyz, v = velocity.xyz;
            moveNode(force, joint.inverseMass, body, acceleration, restPosition, x, v);
            displacement.xyz = x;
            velocity = vec4(v, max(velocity.w, dot(v, v)));
        } else {
            velocity = vec4(0.0);
        }
        if (look && broken != 0u && there) joint = jointOf(cell, slot);
    }
    if (owned) {
        imageStore(newNodes, ivec3(texel, displacementLayer(slot)), displacement);
        imageStore(newNodes, ivec3(texel, velocityLayer(slot)), velocity);
    }
    if (firstLook >= substeps) return;
    // A cell's joints come from eight invocations: masks, then inverse masses.
    barrier();
    forces[slot * BLOCK_CELLS + place] = float(joint.mask);
    forces[(8 + slot) * BLOCK_CELLS + place] = joint.inverseMass;
    barrier();
    if (!owned || slot != 0) return;
    imageStore(newBonds, ivec3(texel, 0), damage);
    imageStore(newBonds, ivec3(texel, 1), slow);
    vec4 masks, low, high;
    for (int k = 0; k < 4; ++k) {
        masks[k] = forces[2 * k * BLOCK_CELLS + place] + 256.0 * forces[(2 * k + 1) * BLOCK_CELLS + place];
        low[k] = forces[(8 + k) * BLOCK_CELLS + place];
        high[k] = forces[(12 + k) * BLOCK_CELLS + place];
    }
    imageStore(newLinks, ivec3(texel, 0), masks);
    imageStore(newLinks, ivec3(texel, 1), low);
    imageStore(newLinks, ivec3(texel, 2), high);
}
