// The mesh that is seen: closed sections that interlock, whatever the parameters.
#include "surface/display_mesh.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "catch.hpp"
#include "core/links.hpp"
#include "core/strength_map.hpp"
#include "support/display_sections.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

using Corners = std::array<Vec3, 3>;

/// Triangles by the cell whose section they belong to, and by its face.
struct Sections {
    std::map<int, std::array<std::vector<std::array<Point, 3>>, 6>> faces;

    explicit Sections(const surface::DisplayMesh& mesh) {
        for (std::size_t i = 0; i < mesh.indices().size(); i += 3) {
            const surface::DisplayVertex& first = mesh.vertices()[mesh.indices()[i]];
            auto& face =
                faces[static_cast<int>(first.cell)][first.code >> SUNDER_DISPLAY_FACE_BIT & 7];
            auto& triangle = face.emplace_back();
            for (int k = 0; k < 3; ++k) triangle[k] = point(mesh.vertices()[mesh.indices()[i + k]]);
        }
    }
};

Corners corners(const std::array<Point, 3>& triangle) {
    Corners result;
    for (int k = 0; k < 3; ++k)
        result[k] = Eigen::Map<const Eigen::Vector3f>(triangle[k].data()).cast<double>();
    return result;
}

template <class Section>
double volume(const Section& section) {
    double sum = 0;
    for (const auto& face : section)
        for (const auto& triangle : face) {
            const Corners c = corners(triangle);
            sum += c[0].dot(c[1].cross(c[2])) / 6;
        }
    return sum;
}

/// How often a closed surface goes round a point: 1 inside, 0 outside, anything else where it folds
/// over itself (van Oosterom and Strackee 1983: the solid angle of a triangle).
template <class Section>
double windingNumber(const Section& section, const Vec3& p) {
    double sum = 0;
    for (const auto& face : section)
        for (const auto& triangle : face) {
            Corners c = corners(triangle);
            for (Vec3& corner : c) corner = (corner - p).normalized();
            const double upper = c[0].dot(c[1].cross(c[2]));
            const double lower = 1 + c[0].dot(c[1]) + c[1].dot(c[2]) + c[2].dot(c[0]);
            sum += 2 * std::atan2(upper, lower);
        }
    return sum / (4 * std::numbers::pi);
}

/// Each edge is there as often one way as the other, so the surface is closed.
template <class Section>
bool closed(const Section& section) {
    std::map<std::pair<Point, Point>, int> edges;
    for (const auto& face : section)
        for (const auto& triangle : face)
            for (int k = 0; k < 3; ++k) {
                const Point &a = triangle[k], &b = triangle[(k + 1) % 3];
                if (a == b) return false;
                if (a < b)
                    ++edges[{a, b}];
                else
                    --edges[{b, a}];
            }
    return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

/// The same triangles, turned round, whichever corner they start with.
std::multiset<std::array<Point, 3>> turned(const std::vector<std::array<Point, 3>>& face,
                                           bool reverse) {
    std::multiset<std::array<Point, 3>> result;
    for (auto triangle : face) {
        if (reverse) std::swap(triangle[1], triangle[2]);
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                    triangle.end());
        result.insert(triangle);
    }
    return result;
}

}  // namespace

TEST_CASE("sections are closed, interlock and fill the wall, for 200 seeds and wild parameters",
          "[display]") {
    for (int seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const World world(wildWall(seed));
        const Body& body = world.bodies()[0];
        const Sections sections{surface::DisplayMesh(world)};
        REQUIRE(static_cast<int>(sections.faces.size()) == world.presentCells());

        double sum = 0;
        for (const auto& [cell, section] : sections.faces) {
            CAPTURE(cell);
            REQUIRE(closed(section));
            const double own = volume(section);
            REQUIRE(own > 0);
            sum += own;
            for (int axis = 0; axis < 3; ++axis) {
                const int next = world.neighbour(cell, axis, +1);
                if (next < 0) continue;
                REQUIRE(turned(section[2 * axis + 1], false) ==
                        turned(sections.faces.at(next)[2 * axis], true));
            }
        }
        // 1e-5: vertices are single-precision numbers, some metres from the origin.
        const double expected = body.cellSize.prod() * world.presentCells();
        REQUIRE(sum == Approx(expected).epsilon(1e-5));

        // Every point of the wall is in exactly one section, once.
        Random random(1000 + static_cast<std::uint64_t>(seed));
        for (int i = 0; i < 4; ++i) {
            const Vec3 u = 0.5 * (random.vector() + Vec3(1, 1, 1));
            const Vec3 size = body.cellSize.cwiseProduct(body.cells.cast<double>());
            const Vec3 p = body.origin + u.cwiseProduct(size);
            const IVec3 c = u.cwiseProduct(body.cells.cast<double>()).cast<int>();
            if (!world.present(body.cellAt(c))) continue;
            std::vector<double> windings;
            for (const auto& [cell, section] : sections.faces)
                windings.push_back(windingNumber(section, p));
            std::sort(windings.begin(), windings.end());
            CAPTURE(p.transpose());
            // 1e-6: rounding. A point that lies on a face by chance would be off by one half.
            REQUIRE(windings.back() == Approx(1).margin(1e-6));
            REQUIRE(windings.front() == Approx(0).margin(1e-6));
            if (windings.size() > 1) REQUIRE(windings[windings.size() - 2] < 1e-6);
        }
    }
}

TEST_CASE("the outside of a wall stays flat and its edges straight", "[display]") {
    for (int seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        const World world(wildWall(seed));
        const Body& body = world.bodies()[0];
        int outside = 0;
        for (const surface::DisplayVertex& v : verticesOf(world)) {
            if (v.code & SUNDER_DISPLAY_FACE_INNER) continue;
            ++outside;
            const int face = static_cast<int>(v.code >> SUNDER_DISPLAY_FACE_BIT & 7),
                      axis = face / 2;
            const IVec3 c = body.coordinates(static_cast<int>(v.cell));
            const double plane = body.origin[axis] + (c[axis] + face % 2) * body.cellSize[axis];
            REQUIRE(v.rest[axis] == static_cast<float>(plane));
        }
        CHECK(outside > 0);
    }
}

TEST_CASE("a seed makes the same sections again, another makes others", "[display]") {
    WorldDescription description = wildWall(7);
    const auto make = [&](std::uint64_t seed) {
        description.seed = seed;
        std::vector<Point> points;
        for (const surface::DisplayVertex& v : verticesOf(World(description)))
            points.push_back(point(v));
        return points;
    };
    const std::vector<Point> first = make(1), again = make(1), other = make(2);
    CHECK(first == again);
    REQUIRE(first.size() == other.size());
    CHECK(first != other);
}

TEST_CASE("without edge points and random sizes sections are the cells", "[display]") {
    const World world(block({4, 3, 1}, softElastic()));
    const surface::DisplayMesh mesh(world);
    // Six faces of four corners, as on the thesis's rubber.
    CHECK(mesh.vertices().size() == std::size_t{24} * world.cellCount());
    CHECK(mesh.indices().size() == std::size_t{36} * world.cellCount());
    std::set<Point> points;
    for (const surface::DisplayVertex& v : mesh.vertices()) points.insert(point(v));
    std::set<Point> corners;
    for (int node = 0; node < world.nodeCount(); ++node) {
        const Eigen::Vector3f x = world.restPosition(node).cast<float>();
        corners.insert({x[0], x[1], x[2]});
    }
    CHECK(points == corners);
}

TEST_CASE("the thesis's edge points: as many as the frequency, as far as the amplitude",
          "[display]") {
    Material m = softElastic();
    m.avgDisplaySectionWidth = m.avgDisplaySectionHeight = 0.1;  // the size of the cells
    m.horizEdgeFrequency = 3;
    m.horizEdgeAmplitude = 0.02;
    const World world(block({3, 2, 1}, m));
    const Body& body = world.bodies()[0];
    const surface::DisplayLattice lattice(world, 0, 100);
    CHECK(lattice.segments()[0] == 4);
    CHECK(lattice.segments()[1] == 1);
    // Along the edge between the two rows, at the front.
    double most = 0;
    for (int i = 0; i < lattice.size()[0]; ++i) {
        const double y = lattice.position({i, 1, lattice.size()[2] - 1})[1] - body.cellSize[1];
        CAPTURE(i, y);
        CHECK(std::abs(y) <= 0.02);
        const bool corner = i % 4 == 0;
        CHECK((std::abs(y) > 0.2 * 0.02) == !corner);
        most = std::max(most, std::abs(y));
    }
    CHECK(most > 0.014);
}

TEST_CASE("a mesh that would be too large has fewer edge points, or is refused", "[display]") {
    Material m = softElastic();
    m.horizEdgeFrequency = m.vertEdgeFrequency = 9;
    m.horizEdgeAmplitude = m.vertEdgeAmplitude = 0.02;
    m.avgDisplaySectionWidth = m.avgDisplaySectionHeight = 0.1;
    const World world(block({3, 3, 1}, m));
    const surface::DisplayMesh whole(world);
    CHECK_FALSE(whole.simplified());
    const std::int64_t size = static_cast<std::int64_t>(whole.vertices().size());
    CHECK_FALSE(surface::DisplayMesh(world, size).simplified());
    const surface::DisplayMesh fewer(world, size - 1);
    CHECK(fewer.simplified());
    CHECK(fewer.vertices().size() < whole.vertices().size());
    CHECK(fewer.vertices().size() > whole.vertices().size() / 2);
    // Bare cells have 24 each.
    CHECK(surface::DisplayMesh(world, 24 * 9).vertices().size() == 24 * 9);
    CHECK_THROWS_WITH(
        surface::DisplayMesh(world, 24 * 9 - 1),
        Catch::Contains("216 vertices, more than 215") && Catch::Contains("--mesh simulation"));
}

TEST_CASE("edges differ from front to back: splinters, not a sawn profile", "[display]") {
    Material m = softElastic();
    m.horizEdgeFrequency = m.vertEdgeFrequency = 2;
    m.horizEdgeAmplitude = m.vertEdgeAmplitude = 0.02;
    m.avgDisplaySectionWidth = m.avgDisplaySectionHeight = 0.1;
    const World world(block({3, 3, 1}, m));
    const surface::DisplayLattice lattice(world, 0, 100);
    REQUIRE(lattice.segments()[2] >= 2);
    int differing = 0, points = 0;
    for (int i = 0; i < lattice.size()[0]; ++i) {
        if (i % lattice.segments()[0] == 0) continue;
        const int row = lattice.segments()[1], back = lattice.size()[2] - 1;
        ++points;
        differing += std::abs(lattice.position({i, row, 0})[1] -
                              lattice.position({i, row, back})[1]) > 0.002;
    }
    CHECK(points == 6);
    CHECK(differing >= 4);
}

TEST_CASE("broken edges of bricks stay in the mortar", "[display]") {
    Material m = softElastic();
    m.clusters = ClusterKind::RunningBond;
    m.clusterSize = {0.44, 0.21, 0};  // not a whole number of cells: corners have to move
    m.jointWidth = 0.012;
    m.horizEdgeFrequency = m.vertEdgeFrequency = 2;
    m.horizEdgeAmplitude = m.vertEdgeAmplitude = 0.05;
    m.avgDisplaySectionWidth = m.avgDisplaySectionHeight = 0.1;
    m.randDisplaySectionWidth = m.randDisplaySectionHeight = 0.05;
    const World world(block({20, 8, 1}, m));
    const Body& body = world.bodies()[0];
    const surface::DisplayLattice lattice(world, 0, 100);
    int bed = 0, head = 0, inside = 0;
    for (const surface::DisplayVertex& v : verticesOf(world)) {
        if (!(v.code & SUNDER_DISPLAY_FACE_INNER)) continue;
        const Vec3 p = v.rest.cast<double>() - body.origin;
        const int axis = static_cast<int>(v.code >> SUNDER_DISPLAY_FACE_BIT & 7) / 2;
        if (!(v.code & SUNDER_DISPLAY_FACE_BOUNDARY)) {
            ++inside;
            continue;
        }
        const double row = p[1] / 0.21;
        if (axis == 1) {
            ++bed;
            CHECK(std::abs(row - std::round(row)) * 0.21 <= 0.0061);
        } else if (std::abs(row - std::round(row)) * 0.21 > 0.011) {
            // Well inside a row, so that it is known which.
            ++head;
            const double brick = p[0] / 0.44 + (static_cast<int>(row) & 1 ? 0.5 : 0);
            CHECK(std::abs(brick - std::round(brick)) * 0.44 <= 0.0061);
        }
    }
    CHECK(bed > 100);
    CHECK(head > 30);
    CHECK(inside > 500);
}

TEST_CASE("chunks have the outline of their Voronoi cells, not the stairs of the lattice",
          "[display]") {
    Material m = softElastic();
    m.clusters = ClusterKind::Voronoi;
    m.clusterSize = {0.4, 0.4, 0};
    const World world(block({30, 20, 1}, m));
    const Body& body = world.bodies()[0];
    const std::uint64_t seed = world.bodySeed(0);
    int on = 0, all = 0;
    for (const surface::DisplayVertex& v : verticesOf(world)) {
        if (!(v.code & SUNDER_DISPLAY_FACE_BOUNDARY)) continue;
        const Vec3 p = v.rest.cast<double>() - body.origin;
        // On the rim of the wall points only move along it.
        if (p[0] < 1e-6 || p[0] > 3 - 1e-6 || p[1] < 1e-6 || p[1] > 2 - 1e-6) continue;
        ++all;
        std::set<std::uint64_t> around;
        for (int i = 0; i < 16; ++i) {
            const double angle = i * std::numbers::pi / 8;
            around.insert(
                clusterOf(m, p + 0.006 * Vec3(std::cos(angle), std::sin(angle), 0), seed));
        }
        on += around.size() >= 2;
    }
    REQUIRE(all > 1000);
    // Those whose boundary is further off than a corner may move are left out.
    CHECK(on > 0.9 * all);
}
