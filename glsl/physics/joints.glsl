// Which nodes of a cell are joined to which, and the masses of their groups. Where damage lies is the solver's affair: the file
// that includes this defines heldBy().
#include "physics/lattice.glsl"
#include "physics/links.glsl"

uniform samplerBuffer released;  // x: 1 where a body's anchors have let go

// Bits 0, 1, 2: the bonds through the +x, +y, +z faces of a cell that hold. offset: where it is on the lattice, from the cell whose
// joints they are; within the body.
uint heldBy(int cell, ivec3 offset);

uint heldWith(vec3 damage) { return uint(damage.x < 1.0) | uint(damage.y < 1.0) << 1u | uint(damage.z < 1.0) << 2u; }

// Sides of its cell that a step on the lattice crosses: bits for −x, −y, −z, +x, +y, +z.
uint sidesCrossed(ivec3 offset) {
    return uint(offset.x < 0) | uint(offset.y < 0) << 1u | uint(offset.z < 0) << 2u |
           uint(offset.x > 0) << 3u | uint(offset.y > 0) << 4u | uint(offset.z > 0) << 5u;
}

// Of the eight cells around a lattice point: bonds they own that hold; masses of a corner, kg; corners that are anchored.
struct Around {
    uint held[8];
    float masses[8];
    uint anchors[8];
};

// What a node has part in: its group's link mask, and 1/kg; 0 where that is anchored.
struct Joint {
    uint mask;
    float inverseMass;
};

Joint jointOf(int corner, Around around) {
    uvec3 bonds_ = uvec3(0u);
    for (int octant = 0; octant < 8; ++octant)
        for (int axis = 0; axis < 3; ++axis)
            if ((octant >> axis & 1) == 0) bonds_[axis] |= (around.held[octant] >> uint(axis) & 1u) << uint(octant);
    uint mask = linkMask(bonds_, corner ^ 7);
    // The same order for every copy of the lattice point, as for forces.
    float mass = 0.0;
    bool anchored = false;
    for (int octant = 0; octant < 8; ++octant) {
        bool joined = (mask >> uint(octant) & 1u) != 0u;
        mass += joined ? around.masses[octant] : 0.0;
        anchored = anchored || (joined && (around.anchors[octant] >> uint(octant ^ 7) & 1u) != 0u);
    }
    return Joint(mask, anchored ? 0.0 : 1.0 / mass);
}

uint anchorsOf(uvec4 record, bool letGo) { return letGo ? 0u : record.x >> uint(SUNDER_CELL_ANCHORS_BIT) & 255u; }

// Of one corner of a cell that is there.
Joint jointOf(int cell, int corner) {
    uvec4 record = cellRecord(cell);
    bool letGo = texelFetch(released, bodyOf(record)).x > 0.0;
    ivec3 strides = cellStrides(ivec4(bodyRecord(bodyOf(record)).lattice));
    Around around;
    for (int octant = 0; octant < 8; ++octant) {
        ivec3 offset = cornerBits(octant) - cornerBits(corner ^ 7), steps = offset * strides;
        // Beyond the body's sides the cell stands for its neighbour; it owns no bond there.
        bool inside = (record.x >> uint(SUNDER_CELL_SIDES_BIT) & sidesCrossed(offset)) == 0u;
        int other = inside ? cell + steps.x + steps.y + steps.z : cell;
        uvec4 otherRecord = cellRecord(other);
        around.held[octant] = inside ? heldBy(other, offset) : 0u;
        around.masses[octant] = cornerMass(otherRecord);
        around.anchors[octant] = anchorsOf(otherRecord, letGo);
    }
    return jointOf(corner, around);
}

// Of all corners of a cell.
LinkRecord joints(int cell) {
    uvec4 record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return LinkRecord(vec4(0.0), vec4(0.0), vec4(0.0));
    bool letGo = texelFetch(released, bodyOf(record)).x > 0.0;
    ivec3 strides = cellStrides(ivec4(bodyRecord(bodyOf(record)).lattice));

    // Of the 27 cells around this one, as in Around.
    uint held[27];
    float masses[27];
    uint anchors[27];
    for (int i = 0; i < 27; ++i) {
        ivec3 offset = ivec3(i % 3, i / 3 % 3, i / 9) - 1, steps = offset * strides;
        bool inside = (record.x >> uint(SUNDER_CELL_SIDES_BIT) & sidesCrossed(offset)) == 0u;
        int other = inside ? cell + steps.x + steps.y + steps.z : cell;
        uvec4 otherRecord = cellRecord(other);
        held[i] = inside ? heldBy(other, offset) : 0u;
        masses[i] = cornerMass(otherRecord);
        anchors[i] = anchorsOf(otherRecord, letGo);
    }
    uint masks[8];
    float inverseMass[8];
    for (int corner = 0; corner < 8; ++corner) {
        Around around;
        for (int octant = 0; octant < 8; ++octant) {
            ivec3 offset = cornerBits(octant) - cornerBits(corner ^ 7) + 1;
            int member = offset.x + 3 * offset.y + 9 * offset.z;
            around.held[octant] = held[member];
            around.masses[octant] = masses[member];
            around.anchors[octant] = anchors[member];
        }
        Joint joint = jointOf(corner, around);
        masks[corner] = joint.mask;
        inverseMass[corner] = joint.inverseMass;
    }
    return LinkRecord(vec4(masks[0] + 256u * masks[1], masks[2] + 256u * masks[3], masks[4] + 256u * masks[5],
                           masks[6] + 256u * masks[7]),
                      vec4(inverseMass[0], inverseMass[1], inverseMass[2], inverseMass[3]),
                      vec4(inverseMass[4], inverseMass[5], inverseMass[6], inverseMass[7]));
}
