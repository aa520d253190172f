#include "surface/display_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "core/strength_map.hpp"
#include "core/tetrahedra.hpp"

namespace sunder::surface {

using namespace core;

namespace {

/// Share of a cell's edge that a point may move across it. Below one half, or two opposite faces
/// could meet.
constexpr double kMostShift = 0.45;
/// Share of a cell's edge that a corner moves at random; the rest is left for the zig-zag.
constexpr double kMostJitter = 0.3;
/// How far points move along their edge, in segments: "randomly placed" (thesis, 8.2).
constexpr double kAlongJitter = 0.25;
/// The least share of its volume that a tetrahedron of the lattice keeps.
constexpr double kLeastVolume = 0.02;
/// Displacements around a tetrahedron below that shrink by these until it has it: of edge points,
/// and once those are used up of corners.
constexpr double kShrinkDetail = 0.8, kShrinkBase = 0.93;
/// Segments of a cell through a wall's thickness, so that edges are not the same front and back.
constexpr int kMostDepthSegments = 3;

enum Shrinks : std::uint8_t { kDetail = 1, kBase = 2 };

enum Purpose : std::uint64_t { kCornerJitter = 101, kZigzag, kFlip, kAlong };

/// Edge points that one cell's edge of length `cell` gets, plus one.
int segmentsAlong(double cell, double section, double frequency, double amplitude) {
    if (frequency < 0.5 || amplitude <= 0) return 1;
    const double segments = cell * (std::round(frequency) + 1) / section;
    return std::clamp(static_cast<int>(std::lround(std::min(segments, 1e6))), 2, 21);
}

/// Materials of a body's cells, each once.
std::vector<const Material*> materialsOf(const World& world, const Body& body) {
    std::vector<const Material*> materials;
    for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
        if (!world.present(cell)) continue;
        const Material* material = &world.materialOf(cell);
        if (std::find(materials.begin(), materials.end(), material) == materials.end())
            materials.push_back(material);
    }
    return materials;
}

/// How far points on a face with normal `axis` zig-zag inside this material, m.
double amplitudeAcross(const Material& material, int axis) {
    const double horizontal = material.horizEdgeFrequency < 0.5 ? 0 : material.horizEdgeAmplitude;
    const double vertical = material.vertEdgeFrequency < 0.5 ? 0 : material.vertEdgeAmplitude;
    return axis == 0 ? vertical : axis == 1 ? horizontal : std::min(horizontal, vertical);
}

/// How far a corner moves along `axis` at random, each way, m.
double jitterAlong(const Material& material, int axis) {
    const double width = material.randDisplaySectionWidth / 2;
    const double height = material.randDisplaySectionHeight / 2;
    return axis == 0 ? width : axis == 1 ? height : std::min(width, height);
}

bool hasJoints(const Material& material) {
    return material.clusters == ClusterKind::RunningBond ||
           material.clusters == ClusterKind::Planks;
}

}  // namespace

IVec3 displaySegments(const World& world, int bodyIndex) {
    const Body& body = world.bodies()[bodyIndex];
    IVec3 segments(1, 1, 1);
    for (const Material* m : materialsOf(world, body)) {
        segments[0] =
            std::max(segments[0], segmentsAlong(body.cellSize[0], m->avgDisplaySectionWidth,
                                                m->horizEdgeFrequency, m->horizEdgeAmplitude));
        segments[1] =
            std::max(segments[1], segmentsAlong(body.cellSize[1], m->avgDisplaySectionHeight,
                                                m->vertEdgeFrequency, m->vertEdgeAmplitude));
    }
    if (segments[0] == 1 && segments[1] == 1) return segments;
    double spacing = 1e300;
    for (int axis = 0; axis < 2; ++axis)
        if (segments[axis] > 1) spacing = std::min(spacing, body.cellSize[axis] / segments[axis]);
    segments[2] = std::clamp(static_cast<int>(std::lround(body.cellSize[2] / spacing)), 2,
                             kMostDepthSegments);
    return segments;
}

/// Makes a lattice, step by step in this order.
struct DisplayLattice::Maker {
    DisplayLattice& lattice;
    const World& world;
    const Body& body;
    const std::uint64_t seed;
    const IVec3 n;                              ///< segments
    std::vector<std::uint64_t> clusters;        ///< per cell
    std::vector<Vec3> cornerShift;              ///< m, per corner of cells
    std::array<std::vector<double>, 3> across;  ///< m, zig-zag of points on planes, per axis
    std::vector<Vec3> base;                     ///< m, per point: how cells' corners move it
    std::vector<Vec3> detail;                   ///< m, per point: as an edge point, on top

    Maker(DisplayLattice& target, const World& source, int bodyIndex)
        : lattice(target),
          world(source),
          body(source.bodies()[bodyIndex]),
          seed(source.bodySeed(bodyIndex)),
          n(target.segments_) {}

    int cornerIndex(const IVec3& c) const {
        return c[0] + (body.cells[0] + 1) * (c[1] + (body.cells[1] + 1) * c[2]);
    }
    Vec3 centre(const IVec3& c) const {
        return (c.cast<double>() + Vec3(.5, .5, .5)).cwiseProduct(body.cellSize);
    }
    Vec3 undisplaced(const IVec3& p) const {
        return p.cast<double>().cwiseQuotient(n.cast<double>()).cwiseProduct(body.cellSize);
    }
    bool present(const IVec3& c) const { return body.contains(c) && world.present(body.cellAt(c)); }
    static std::uint64_t key(std::uint64_t plane, int a, int b) {
        return (plane << 48) ^ (static_cast<std::uint64_t>(a) << 24) ^
               static_cast<std::uint64_t>(b);
    }
    double uniform(std::uint64_t which, Purpose purpose) const {
        return hashUniform(seed, which, purpose);
    }

    /// First and last cell around fine coordinate p of `axis`: equal unless p is on a plane.
    std::array<int, 2> cellsAround(int p, int axis) const {
        return {p % n[axis] == 0 ? p / n[axis] - 1 : p / n[axis], p / n[axis]};
    }

    /// Calls visit(low, high) for the pairs of cells across the plane of `axis` through p that
    /// touch the point p; either may be outside the body.
    template <class Visit>
    void pairsAcross(const IVec3& p, int axis, const Visit& visit) const {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        const auto around = cellsAround(p[axis], axis);
        const auto bs = cellsAround(p[b], b), cs = cellsAround(p[c], c);
        for (int j = bs[0]; j <= bs[1]; ++j)
            for (int k = cs[0]; k <= cs[1]; ++k) {
                IVec3 low, high;
                low[axis] = around[0];
                high[axis] = around[1];
                low[b] = high[b] = j;
                low[c] = high[c] = k;
                visit(low, high);
            }
    }

    void findClusters() {
        clusters.resize(body.cellCount());
        lattice.boundary_.assign(body.cellCount(), 0);
        for (int i = 0; i < body.cellCount(); ++i) {
            const int cell = body.firstCell + i;
            if (world.present(cell))
                clusters[i] =
                    clusterOf(world.materialOf(cell), centre(body.coordinates(cell)), seed);
        }
        for (int i = 0; i < body.cellCount(); ++i) {
            const IVec3 c = body.coordinates(body.firstCell + i);
            for (int axis = 0; axis < 3; ++axis) {
                IVec3 next = c;
                ++next[axis];
                if (!present(c) || !present(next)) continue;
                const int j = body.cellAt(next) - body.firstCell;
                if (clusters[i] != clusters[j]) lattice.boundary_[i] |= 1u << axis;
            }
        }
    }

    void findOutside() {
        lattice.outside_.assign(lattice.positions_.size(), 0);
        forEachPoint([&](const IVec3& p) {
            for (int axis = 0; axis < 3; ++axis) {
                if (p[axis] % n[axis] != 0) continue;
                pairsAcross(p, axis, [&](const IVec3& low, const IVec3& high) {
                    if (present(low) != present(high))
                        lattice.outside_[lattice.index(p)] |= 1u << axis;
                });
            }
        });
    }

    template <class Visit>
    void forEachPoint(const Visit& visit) const {
        IVec3 p;
        for (p[2] = 0; p[2] < lattice.size_[2]; ++p[2])
            for (p[1] = 0; p[1] < lattice.size_[1]; ++p[1])
                for (p[0] = 0; p[0] < lattice.size_[0]; ++p[0]) visit(p);
    }

    /// By how much a corner where clusters of one material meet must move to be on their boundary;
    /// zero elsewhere.
    Vec3 towardsBoundary(const IVec3& corner, const Eigen::Array3i& free) const {
        std::vector<Vec3> centres;
        const Material* material = nullptr;
        std::uint64_t cluster = 0;
        bool several = false;
        for (int octant = 0; octant < 8; ++octant) {
            const IVec3 c = corner - IVec3(octant & 1, octant >> 1 & 1, octant >> 2);
            if (!present(c)) continue;
            const int cell = body.cellAt(c);
            const std::uint64_t own = clusters[cell - body.firstCell];
            if (material && &world.materialOf(cell) != material) return Vec3::Zero();
            if (material && own != cluster) several = true;
            material = &world.materialOf(cell);
            cluster = own;
            centres.push_back(centre(c));
        }
        if (!several) return Vec3::Zero();
        const Vec3 p = corner.cast<double>().cwiseProduct(body.cellSize);
        const Vec3 reach = (kMostShift * body.cellSize).cwiseProduct(free.cast<double>().matrix());
        return towardsClusterBoundary(*material, p, centres, reach, seed);
    }

    void shiftCorners() {
        cornerShift.assign((body.cells.array() + 1).prod(), Vec3::Zero());
        IVec3 corner;
        for (corner[2] = 0; corner[2] <= body.cells[2]; ++corner[2])
            for (corner[1] = 0; corner[1] <= body.cells[1]; ++corner[1])
                for (corner[0] = 0; corner[0] <= body.cells[0]; ++corner[0]) {
                    const unsigned outside =
                        lattice.outside_[lattice.index(corner.cwiseProduct(n))];
                    const Eigen::Array3i free(!(outside & 1), !(outside & 2), !(outside & 4));
                    Vec3& shiftHere = cornerShift[cornerIndex(corner)];
                    shiftHere = towardsBoundary(corner, free);
                    if (!shiftHere.isZero(0)) continue;
                    for (int axis = 0; axis < 3; ++axis)
                        if (free[axis]) shiftHere[axis] = cornerJitter(corner, axis);
                }
    }

    /// A corner's random displacement, m: by the least of what its cells' materials say. A corner
    /// on a joint stays there.
    double cornerJitter(const IVec3& corner, int axis) const {
        double most = kMostJitter * body.cellSize[axis];
        pairsAcross(corner.cwiseProduct(n), axis, [&](const IVec3& low, const IVec3& high) {
            if (!present(low) || !present(high)) return;
            for (const IVec3& c : {low, high}) {
                const Material& material = world.materialOf(body.cellAt(c));
                most = std::min(most, hasJoints(material) && lattice.clusterBoundary(low, axis)
                                          ? 0
                                          : jitterAlong(material, axis));
            }
        });
        const auto which =
            key(3 * static_cast<std::uint64_t>(corner[2]) + axis, corner[0], corner[1]);
        return most * (2 * uniform(which, kCornerJitter) - 1);
    }

    /// How far the point may zig-zag: the least of the faces that it lies on, m.
    double amplitude(const IVec3& p, int axis) const {
        double most = kMostShift * body.cellSize[axis];
        pairsAcross(p, axis, [&](const IVec3& low, const IVec3& high) {
            if (!present(low) || !present(high)) return;
            for (const IVec3& c : {low, high}) {
                const Material& material = world.materialOf(body.cellAt(c));
                most = std::min(most, amplitudeAcross(material, axis));
                if (hasJoints(material) && lattice.clusterBoundary(low, axis))
                    most = std::min(most, material.jointWidth / 2);
            }
        });
        return most;
    }

    /// Number of the edge point at fine coordinate p along `axis`; corners do not count.
    int ordinal(const IVec3& p, int axis) const {
        return p[axis] / n[axis] * std::max(n[axis] - 1, 1) + p[axis] % n[axis];
    }

    /// Zig-zag of a point on a face between cells, −1 to 1. Points along an edge alternate, mostly;
    /// the thickness only varies how far they go, so that what is torn looks like splinters and not
    /// like a sawn profile.
    double zigzag(const IVec3& p, int axis) const {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        const int along = axis == 1   ? ordinal(p, 0)
                          : axis == 0 ? ordinal(p, 1)
                                      : ordinal(p, 0) + ordinal(p, 1);
        const auto which = key(static_cast<std::uint64_t>(axis) + 4 * p[axis], p[b], p[c]);
        const double sign = (along & 1) == (uniform(which, kFlip) < 0.25) ? 1 : -1;
        return sign * (0.3 + 0.7 * uniform(which, kZigzag));
    }

    void zigzagPlanes() {
        for (int axis = 0; axis < 3; ++axis) {
            across[axis].assign(lattice.positions_.size(), 0.0);
            const int b = (axis + 1) % 3, c = (axis + 2) % 3;
            IVec3 p;
            for (int plane = 1; plane < body.cells[axis]; ++plane) {
                p[axis] = plane * n[axis];
                for (p[b] = 0; p[b] < lattice.size_[b]; ++p[b])
                    for (p[c] = 0; p[c] < lattice.size_[c]; ++p[c]) {
                        const bool corner = p[b] % n[b] == 0 && p[c] % n[c] == 0;
                        if (corner || lattice.outside(p, axis)) continue;
                        const int i = lattice.index(p);
                        const double room =
                            kMostShift * body.cellSize[axis] - std::abs(base[i][axis]);
                        across[axis][i] = std::min(amplitude(p, axis), room) * zigzag(p, axis);
                    }
            }
        }
    }

    /// Trilinear between the corners of a cell.
    void movePointsWithCorners() {
        base.assign(lattice.positions_.size(), Vec3::Zero());
        forEachPoint([&](const IVec3& p) {
            const IVec3 low = p.cwiseQuotient(n);
            const Vec3 t = (p - low.cwiseProduct(n)).cast<double>().cwiseQuotient(n.cast<double>());
            for (int corner = 0; corner < 8; ++corner) {
                const IVec3 o(corner & 1, corner >> 1 & 1, corner >> 2);
                double weight = 1;
                for (int axis = 0; axis < 3; ++axis) weight *= o[axis] ? t[axis] : 1 - t[axis];
                if (weight > 0)
                    base[lattice.index(p)] += weight * cornerShift[cornerIndex(low + o)];
            }
        });
    }

    /// Linear between the planes on either side; besides, points between planes are moved a little
    /// along.
    void addDetail() {
        detail.assign(lattice.positions_.size(), Vec3::Zero());
        forEachPoint([&](const IVec3& p) {
            const int i = lattice.index(p);
            for (int axis = 0; axis < 3; ++axis) {
                const int within = p[axis] % n[axis];
                IVec3 low = p, high = p;
                low[axis] -= within;
                high[axis] += within == 0 ? 0 : n[axis] - within;
                const double t = static_cast<double>(within) / n[axis];
                detail[i][axis] = (1 - t) * across[axis][lattice.index(low)] +
                                  t * across[axis][lattice.index(high)];
                if (within == 0 || std::none_of(across.begin(), across.end(),
                                                [&](const auto& a) { return a[i] != 0; }))
                    continue;
                const auto which = key(4 * static_cast<std::uint64_t>(p[2]) + axis, p[0], p[1]);
                detail[i][axis] +=
                    kAlongJitter * body.cellSize[axis] / n[axis] * (2 * uniform(which, kAlong) - 1);
            }
        });
    }

    /// Reduces displacements until every tetrahedron of the lattice keeps kLeastVolume of its
    /// volume: then the displaced lattice maps one to one, and no section folds. It ends: without
    /// displacement all hold.
    void unfold() {
        const IVec3 boxes = lattice.size_ - IVec3(1, 1, 1);
        std::vector<IVec3> suspects;
        IVec3 box;
        for (box[2] = 0; box[2] < boxes[2]; ++box[2])
            for (box[1] = 0; box[1] < boxes[1]; ++box[1])
                for (box[0] = 0; box[0] < boxes[0]; ++box[0])
                    if (present(box.cwiseQuotient(n))) suspects.push_back(box);
        std::vector<std::uint8_t> shrink(base.size(), 0), listed;
        while (!suspects.empty()) {
            std::vector<IVec3> folded;
            for (const IVec3& suspect : suspects)
                if (marksFolded(suspect, shrink)) folded.push_back(suspect);
            suspects.clear();
            listed.assign(base.size(), 0);
            for (const IVec3& from : folded)
                for (int dz = -1; dz <= 1; ++dz)
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx) {
                            const IVec3 at = from + IVec3(dx, dy, dz);
                            if ((at.array() < 0).any() || (at.array() >= boxes.array()).any() ||
                                !present(at.cwiseQuotient(n)) || listed[lattice.index(at)])
                                continue;
                            listed[lattice.index(at)] = 1;
                            suspects.push_back(at);
                        }
            for (const IVec3& from : folded)
                for (int corner = 0; corner < 8; ++corner) {
                    const int i =
                        lattice.index(from + IVec3(corner & 1, corner >> 1 & 1, corner >> 2));
                    if (shrink[i] & kDetail) detail[i] *= kShrinkDetail;
                    if (shrink[i] & kBase) base[i] *= kShrinkBase;
                    shrink[i] = 0;
                }
        }
    }

    /// Marks the points of this box's tetrahedra that are too small. Whether there was any.
    bool marksFolded(const IVec3& box, std::vector<std::uint8_t>& marks) const {
        std::array<Vec3, 8> corners;
        std::array<int, 8> indices;
        for (int corner = 0; corner < 8; ++corner) {
            const IVec3 p = box + IVec3(corner & 1, corner >> 1 & 1, corner >> 2);
            indices[corner] = lattice.index(p);
            corners[corner] = undisplaced(p) + base[indices[corner]] + detail[indices[corner]];
        }
        const double least = kLeastVolume * body.cellSize.cwiseQuotient(n.cast<double>()).prod();
        bool any = false;
        for (const Tetrahedron& t : kTetrahedra[box.sum() & 1]) {
            const Vec3 a = corners[t[1]] - corners[t[0]], b = corners[t[2]] - corners[t[0]],
                       c = corners[t[3]] - corners[t[0]];
            if (a.dot(b.cross(c)) >= least) continue;
            any = true;
            // What keeps joints straight goes last.
            const bool detailed = std::any_of(t.begin(), t.end(), [&](int corner) {
                return detail[indices[corner]].norm() > 1e-3 * body.cellSize.minCoeff();
            });
            for (const int corner : t) marks[indices[corner]] |= detailed ? kDetail : kBase;
        }
        return any;
    }

    void place() {
        forEachPoint([&](const IVec3& p) {
            const int i = lattice.index(p);
            lattice.positions_[i] = undisplaced(p) + base[i] + detail[i];
        });
    }
};

DisplayLattice::DisplayLattice(const World& world, int body, int mostSegments)
    : segments_(displaySegments(world, body).cwiseMin(mostSegments)),
      size_(world.bodies()[body].cells.cwiseProduct(segments_) + IVec3(1, 1, 1)),
      cells_(world.bodies()[body].cells),
      positions_(size_.prod()) {
    Maker maker(*this, world, body);
    maker.findClusters();
    maker.findOutside();
    maker.shiftCorners();
    maker.movePointsWithCorners();
    maker.zigzagPlanes();
    maker.addDetail();
    maker.unfold();
    maker.place();
}

bool DisplayLattice::outside(const IVec3& p, int axis) const {
    return outside_[index(p)] >> axis & 1;
}

bool DisplayLattice::clusterBoundary(const IVec3& cell, int axis) const {
    return boundary_[cell[0] + cells_[0] * (cell[1] + cells_[1] * cell[2])] >> axis & 1;
}

}  // namespace sunder::surface
