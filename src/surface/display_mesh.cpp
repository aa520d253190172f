#include "surface/display_mesh.hpp"

#include <algorithm>
#include <array>

#include "core/tetrahedra.hpp"

namespace sunder::surface {

using namespace core;

namespace {

/// Vertices of a cell that is divided like this.
std::int64_t verticesPerCell(const IVec3& segments) {
    std::int64_t sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        sum += 2 * std::int64_t{segments[(axis + 1) % 3] + 1} * (segments[(axis + 2) % 3] + 1);
    return sum;
}

std::int64_t verticesOf(const World& world, const std::vector<IVec3>& segments, int most) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < segments.size(); ++i)
        sum += world.bodies()[i].cellCount() * verticesPerCell(segments[i].cwiseMin(most));
    return sum;
}

/// One face of a section: a grid over the lattice points on it.
class FaceBuilder {
  public:
    FaceBuilder(const World& world, const Body& body, const DisplayLattice& lattice,
                const IVec3& cell)
        : world_(world), body_(body), lattice_(lattice), cell_(cell) {}

    void add(int face, std::vector<DisplayVertex>& vertices,
             std::vector<std::uint32_t>& indices) const {
        const IVec3& n = lattice_.segments();
        const int axis = face / 2, side = face & 1, b = (axis + 1) % 3, c = (axis + 2) % 3;
        const std::uint32_t first = static_cast<std::uint32_t>(vertices.size());
        const std::uint32_t cell = static_cast<std::uint32_t>(body_.cellAt(cell_));
        const std::uint32_t faceCode = codeOfFace(axis, side);
        IVec3 low = cell_;
        low[axis] -= 1 - side;
        const bool inner = faceCode & SUNDER_DISPLAY_FACE_INNER;
        const std::uint32_t owner = inner ? static_cast<std::uint32_t>(body_.cellAt(low)) : cell;
        IVec3 p;
        p[axis] = (cell_[axis] + side) * n[axis];
        for (int j = 0; j <= n[b]; ++j)
            for (int k = 0; k <= n[c]; ++k) {
                p[b] = cell_[b] * n[b] + j;
                p[c] = cell_[c] * n[c] + k;
                vertices.push_back({body_.inWorld(lattice_.position(p)).cast<float>(), cell,
                                    faceCode | codeOfPoint(p), owner});
            }
        const auto at = [&](int j, int k) {
            return first + static_cast<std::uint32_t>(j * (n[c] + 1) + k);
        };
        for (int j = 0; j < n[b]; ++j)
            for (int k = 0; k < n[c]; ++k) {
                // The diagonal of the lattice's tetrahedra, so that the triangles are theirs.
                p[axis] = (cell_[axis] + side) * n[axis] - side;
                p[b] = cell_[b] * n[b] + j;
                p[c] = cell_[c] * n[c] + k;
                const bool rising = side == (p.sum() & 1);
                std::array<std::uint32_t, 4> quad{at(j, k), at(j + 1, k), at(j + 1, k + 1),
                                                  at(j, k + 1)};
                if (side == 0) std::swap(quad[1], quad[3]);
                const std::array<int, 6> order = rising ? std::array<int, 6>{0, 1, 2, 0, 2, 3}
                                                        : std::array<int, 6>{0, 1, 3, 1, 2, 3};
                for (const int corner : order) indices.push_back(quad[corner]);
            }
    }

  private:
    std::uint32_t codeOfFace(int axis, int side) const {
        IVec3 low = cell_;
        if (side == 0) --low[axis];
        std::uint32_t code = static_cast<std::uint32_t>(2 * axis + side) << SUNDER_DISPLAY_FACE_BIT;
        if (world_.neighbour(body_.cellAt(cell_), axis, side == 0 ? -1 : +1) < 0) return code;
        code |= SUNDER_DISPLAY_FACE_INNER;
        if (lattice_.clusterBoundary(low, axis)) code |= SUNDER_DISPLAY_FACE_BOUNDARY;
        return code;
    }

    std::uint32_t codeOfPoint(const IVec3& p) const {
        const IVec3& n = lattice_.segments();
        std::uint32_t code = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] % n[axis] != 0 || p[axis] == 0 || p[axis] == lattice_.size()[axis] - 1)
                continue;
            const int plane = p[axis] / n[axis];
            code |= (plane == cell_[axis] ? 1u : 2u) << (SUNDER_DISPLAY_PLANES_BIT + 2 * axis);
            if (lattice_.outside(p, axis)) code |= 1u << (SUNDER_DISPLAY_OUTSIDE_BIT + axis);
            if (lattice_.position(p)[axis] > plane * body_.cellSize[axis])
                code |= 1u << (SUNDER_DISPLAY_SIDE_BIT + axis);
        }
        return code;
    }

    const World& world_;
    const Body& body_;
    const DisplayLattice& lattice_;
    const IVec3 cell_;
};

/// The cells around a vertex and how it hangs on them. Octants are numbered by their side of the
/// planes that the vertex lies on, as in core/links.hpp.
struct Surroundings {
    int planes = 0;  ///< bit per axis: the vertex lies on a plane between cells
    int own = 0;     ///< octant of the vertex's own cell
    IVec3 place;     ///< lattice coordinates of that cell
};

Surroundings surroundings(const World& world, const DisplayVertex& vertex) {
    Surroundings s;
    const int cell = static_cast<int>(vertex.cell);
    s.place = world.bodies()[world.bodyOf(cell)].coordinates(cell);
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint32_t plane = vertex.code >> (SUNDER_DISPLAY_PLANES_BIT + 2 * axis) & 3;
        if (plane != 0) s.planes |= 1 << axis;
        if (plane == 1) s.own |= 1 << axis;
    }
    return s;
}

int cellIn(const World& world, const Surroundings& s, const Body& body, int octant) {
    IVec3 c = s.place;
    for (int axis = 0; axis < 3; ++axis) c[axis] += (octant >> axis & 1) - (s.own >> axis & 1);
    const int cell = body.cellAt(c);
    return world.present(cell) ? cell : -1;
}

/// Octants whose cells hang together with the vertex's own around it, as bits.
int groupAround(const World& world, const State& state, const Surroundings& s, const Body& body) {
    int group = 1 << s.own;
    for (int before = 0; before != group;) {
        before = group;
        for (int axis = 0; axis < 3; ++axis)
            for (int low = 0; low < 8; ++low) {
                const int high = low | 1 << axis;
                if (low == high || (high & ~s.planes)) continue;
                if (!(group >> low & 1) && !(group >> high & 1)) continue;
                const int cell = cellIn(world, s, body, low);
                if (cell >= 0 && state.damage[kBondsPerCell * cell + axis] < 1)
                    group |= 1 << low | 1 << high;
            }
    }
    return group;
}

/// Corner of a cell and barycentric weight.
struct Binding {
    Tetrahedron corners;
    std::array<double, 4> weights;
};

/// The tetrahedron of a cell that a point lies in, or nearest to. `u`: in the cell, 0 to 1.
Binding bind(const Vec3& u, int parity) {
    // Three corners of a corner tetrahedron are a step along each axis from its apex. Of two that
    // are equally near the first one counts, in this order, lest rounding decide.
    constexpr double kNearer = 1e-4;
    int apex = 0;
    double nearest = 1e300;
    for (int i = 0; i < 4; ++i) {
        const int corner = (i == 0 ? 0 : 7 - (8 >> i)) ^ (parity == 0 ? 7 : 0);
        double distance = 0;
        for (int axis = 0; axis < 3; ++axis) distance += corner >> axis & 1 ? 1 - u[axis] : u[axis];
        if (distance > nearest - kNearer) continue;
        nearest = distance;
        apex = corner;
    }
    Binding binding;
    if (nearest < 1) {
        binding.corners = {apex, apex ^ 1, apex ^ 2, apex ^ 4};
        binding.weights[0] = 1 - nearest;
        for (int axis = 0; axis < 3; ++axis)
            binding.weights[axis + 1] = apex >> axis & 1 ? 1 - u[axis] : u[axis];
    } else {
        binding.corners = kTetrahedra[parity][4];
        for (int i = 0; i < 4; ++i) {
            double distance = 0;
            for (int axis = 0; axis < 3; ++axis)
                distance += binding.corners[i] >> axis & 1 ? 1 - u[axis] : u[axis];
            binding.weights[i] = 1 - distance / 2;
        }
    }
    return binding;
}

}  // namespace

DisplayMesh::DisplayMesh(const World& world, std::int64_t mostVertices) {
    std::vector<IVec3> segments;
    int most = 1;
    for (std::size_t i = 0; i < world.bodies().size(); ++i) {
        segments.push_back(displaySegments(world, static_cast<int>(i)));
        most = std::max(most, segments.back().maxCoeff());
    }
    while (most > 1 && verticesOf(world, segments, most) > mostVertices) {
        --most;
        simplified_ = true;
    }
    const std::int64_t count = verticesOf(world, segments, most);
    if (count > mostVertices)
        throw InputError("the world is too large for its display mesh, which would have " +
                         std::to_string(count) + " vertices, more than " +
                         std::to_string(mostVertices) +
                         "; draw the simulation mesh (--mesh simulation), or use fewer cells");
    vertices_.reserve(count);
    std::vector<std::uint32_t> transparent;
    for (std::size_t i = 0; i < segments.size(); ++i)
        addBody(world, static_cast<int>(i), most, transparent);
    opaqueIndices_ = indices_.size();
    indices_.insert(indices_.end(), transparent.begin(), transparent.end());
}

void DisplayMesh::addBody(const World& world, int index, int mostSegments,
                          std::vector<std::uint32_t>& transparent) {
    const Body& body = world.bodies()[index];
    const DisplayLattice lattice(world, index, mostSegments);
    for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
        if (!world.present(cell)) continue;
        const FaceBuilder builder(world, body, lattice, body.coordinates(cell));
        auto& target = world.materialOf(cell).transparency > 0 ? transparent : indices_;
        for (int face = 0; face < 6; ++face) builder.add(face, vertices_, target);
    }
}

Vec3 displayedPosition(const World& world, const State& state, const DisplayVertex& vertex) {
    const Body& body = world.bodies()[world.bodyOf(static_cast<int>(vertex.cell))];
    const Surroundings s = surroundings(world, vertex);
    const int group = groupAround(world, state, s, body);

    const int side = static_cast<int>(vertex.code >> SUNDER_DISPLAY_SIDE_BIT & 7) & s.planes;
    int octant = s.own;
    for (int turn = 7; turn >= 0; --turn)
        if (!(turn & ~s.planes) && group >> (side ^ turn) & 1) octant = side ^ turn;
    const int cell = cellIn(world, s, body, octant);

    Vec3 rest = vertex.rest.cast<double>();
    for (int axis = 0; axis < 3; ++axis) {
        const bool outside = vertex.code >> (SUNDER_DISPLAY_OUTSIDE_BIT + axis) & 1;
        if (!(s.planes >> axis & 1) || outside) continue;
        int high = 0;  // octants of the group on the high side of this axis's plane
        for (int o = 0; o < 8; ++o)
            if (o >> axis & 1) high |= group & 1 << o;
        const double gap = SUNDER_DISPLAY_GAP * body.cellSize[axis];
        if (high == 0) rest -= gap * body.axes.col(axis);
        if (high == group) rest += gap * body.axes.col(axis);
    }

    const Vec3 own = body.axes.transpose() * (rest - world.restPosition(kCorners * cell));
    const Vec3 u = own.cwiseQuotient(body.cellSize);
    const Binding binding = bind(u, world.parity(cell));
    for (int i = 0; i < 4; ++i)
        rest += binding.weights[i] * state.displacement[kCorners * cell + binding.corners[i]];
    return rest;
}

bool displayHidden(const State& state, const DisplayVertex& vertex) {
    const std::uint32_t axis = (vertex.code >> SUNDER_DISPLAY_FACE_BIT & 7) / 2;
    return (vertex.code & SUNDER_DISPLAY_FACE_INNER) &&
           state.damage[std::size_t{kBondsPerCell} * vertex.bondOwner + axis] < 1;
}

}  // namespace sunder::surface
