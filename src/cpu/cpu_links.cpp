// Link masks and masses of joined groups, after bonds broke.
#include <vector>

#include "core/links.hpp"
#include "cpu/cpu_body.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

/// linkMask() of every octant for all 4,096 states of the twelve bonds around a lattice point.
struct LinkTable {
    std::vector<std::array<std::uint8_t, 8>> masks;
    LinkTable() : masks(4096) {
        for (unsigned held = 0; held < 4096; ++held)
            for (int octant = 0; octant < 8; ++octant) masks[held][octant] = linkMask(held, octant);
    }
};

const LinkTable& linkTable() {
    static const LinkTable table;
    return table;
}

/// The lattice point with cell (x, y, z) in octant 7, which may lie just outside the body.
void relinkPoint(const World& world, BodyArrays& a, const LinkTable& table, int x, int y, int z) {
    const Body& body = world.bodies()[a.index];
    int places[8], cells[8];
    for (int octant = 0; octant < 8; ++octant) {
        const IVec3 c(x - 1 + (octant & 1), y - 1 + (octant >> 1 & 1), z - 1 + (octant >> 2));
        const bool inside = body.contains(c);
        places[octant] = inside ? a.place(c[0], c[1], c[2]) : -1;
        cells[octant] = inside ? body.cellAt(c) : -1;
    }
    unsigned held = 0;
    for (int bond = 0; bond < 12; ++bond) {
        const int place = places[bondOctant(bond)];
        if (place >= 0 && a.damage[bond / 4 * a.stride + place] < 1) held |= 1u << bond;
    }
    for (int octant = 0; octant < 8; ++octant) {
        if (places[octant] < 0) continue;
        const int corner = octant ^ 7;
        const std::uint8_t mask = table.masks[held][octant];
        double mass = 0;
        bool anchored = false;
        for (int member = 0; member < 8; ++member) {
            if (!(mask >> member & 1)) continue;
            const int node = kCorners * cells[member] + (member ^ 7);
            mass += world.nodeMass(node);
            anchored |= world.anchored(node) && !a.released;
        }
        const std::ptrdiff_t at = tiled(kCorners, corner, places[octant]);
        a.links[at] = mask;
        a.inverseMass[at] = anchored || mass == 0 ? 0.f : static_cast<float>(1 / mass);
    }
}

}  // namespace

void relinkAll(const World& world, BodyArrays& a) {
    const LinkTable& table = linkTable();
    for (int z = 0; z <= a.extent[2]; ++z)
        for (int y = 0; y <= a.extent[1]; ++y)
            for (int x = 0; x <= a.extent[0]; ++x) relinkPoint(world, a, table, x, y, z);
    std::fill_n(a.broke, a.stride, std::uint8_t{0});
}

void relinkBroken(const World& world, BodyArrays& a) {
    const LinkTable& table = linkTable();
    for (int z = 0; z < a.extent[2]; ++z)
        for (int y = 0; y < a.extent[1]; ++y) {
            std::uint8_t* row = a.broke + a.place(0, y, z);
            for (int x = 0; x < a.extent[0]; ++x) {
                if (row[x] == 0) continue;
                // Corners of the cell that lie on a face whose bond broke.
                for (int corner = 0; corner < kCorners; ++corner)
                    if (corner & row[x])
                        relinkPoint(world, a, table, x + (corner & 1), y + (corner >> 1 & 1),
                                    z + (corner >> 2));
                row[x] = 0;
            }
        }
}

}  // namespace sunder::cpu
