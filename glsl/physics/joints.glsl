// Which nodes of a cell are joined to which, and the masses of their groups. Where damage lies is the solver's affair: the file
// that includes this defines damageOf().
#include "physics/lattice.glsl"
#include "physics/links.glsl"

uniform samplerBuffer released;  // x: 1 where a body's anchors have let go

vec3 damageOf(int cell);  // of the bonds through its +x, +y, +z faces

LinkRecord joints(int cell) {
    uvec4 record = cellRecord(cell);
    if (lawOf(record) == SUNDER_ABSENT) return LinkRecord(vec4(0.0), vec4(0.0), vec4(0.0));
    bool letGo = texelFetch(released, bodyOf(record)).x > 0.0;
    ivec3 strides = cellStrides(ivec4(bodyRecord(bodyOf(record)).lattice));

    // Of the 27 cells around this one: bits 0, 1, 2 for the bonds they own through their +x, +y, +z faces and that hold; mass of a
    // corner; anchored corners.
    uint held[27];
    float masses[27];
    uint anchors[27];
    for (int i = 0; i < 27; ++i) {
        ivec3 offset = ivec3(i % 3, i / 3 % 3, i / 9) - 1;
        uint sides = uint(offset.x < 0) | uint(offset.y < 0) << 1u | uint(offset.z < 0) << 2u |
                     uint(offset.x > 0) << 3u | uint(offset.y > 0) << 4u | uint(offset.z > 0) << 5u;
        // Beyond the body's sides the cell stands for its neighbour; it owns no bond there.
        bool inside = (record.x >> uint(SUNDER_CELL_SIDES_BIT) & sides) == 0u;
        ivec3 steps = offset * strides;
        int other = inside ? cell + steps.x + steps.y + steps.z : cell;
        uvec4 otherRecord = cellRecord(other);
        masses[i] = cornerMass(otherRecord);
        anchors[i] = letGo ? 0u : otherRecord.x >> uint(SUNDER_CELL_ANCHORS_BIT);
        vec3 damage = damageOf(other);
        held[i] = inside ? uint(damage.x < 1.0) | uint(damage.y < 1.0) << 1u | uint(damage.z < 1.0) << 2u : 0u;
    }
    uint masks[8];
    float inverseMass[8];
    for (int corner = 0; corner < 8; ++corner) {
        int own = corner ^ 7;
        uvec3 around = uvec3(0u);
        for (int octant = 0; octant < 8; ++octant) {
            ivec3 offset = cornerBits(octant) - cornerBits(own) + 1;
            uint owned = held[offset.x + 3 * offset.y + 9 * offset.z];
            for (int axis = 0; axis < 3; ++axis)
                if ((octant >> axis & 1) == 0) around[axis] |= (owned >> uint(axis) & 1u) << uint(octant);
        }
        uint mask = linkMask(around, own);
        masks[corner] = mask;

        // The same order for every copy of the lattice point, as for forces.
        float mass = 0.0;
        bool anchored = false;
        for (int octant = 0; octant < 8; ++octant) {
            ivec3 offset = cornerBits(octant) - cornerBits(own) + 1;
            int member = offset.x + 3 * offset.y + 9 * offset.z;
            bool joined = (mask >> uint(octant) & 1u) != 0u;
            mass += joined ? masses[member] : 0.0;
            anchored = anchored || (joined && (anchors[member] >> uint(octant ^ 7) & 1u) != 0u);
        }
        inverseMass[corner] = anchored ? 0.0 : 1.0 / mass;
    }
    return LinkRecord(vec4(masks[0] + 256u * masks[1], masks[2] + 256u * masks[3], masks[4] + 256u * masks[5],
                           masks[6] + 256u * masks[7]),
                      vec4(inverseMass[0], inverseMass[1], inverseMass[2], inverseMass[3]),
                      vec4(inverseMass[4], inverseMass[5], inverseMass[6], inverseMass[7]));
}
