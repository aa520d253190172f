#include "core/world.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <map>
#include <numbers>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/links.hpp"
#include "core/memory.hpp"
#include "core/pieces.hpp"
#include "core/strength_map.hpp"
#include "core/tetrahedra.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("the thesis's wall has 270 finite elements and 152 nodes") {
    const World world(block({18, 3, 1}, softElastic()));
    std::map<std::array<double, 3>, int> points;
    for (int node = 0; node < world.nodeCount(); ++node) {
        const Vec3 x = world.restPosition(node);
        ++points[{x[0], x[1], x[2]}];  // copies are equal to the bit, or there would be more
    }
    CHECK(kTetrahedraPerCell * world.presentCells() == 270);
    CHECK(points.size() == 152);
}

TEST_CASE("neighbouring cells cut their shared face along the same diagonal") {
    const World world(block({3, 4, 5}, softElastic()));
    for (int cell = 0; cell < world.cellCount(); ++cell)
        for (int axis = 0; axis < 3; ++axis) {
            const int other = world.neighbour(cell, axis, +1);
            if (other < 0) continue;
            const auto diagonal = [&](int c, int end) {
                std::vector<std::array<double, 3>> ends;
                for (const int corner : kTetrahedra[world.parity(c)][4])
                    if ((corner >> axis & 1) == end) {
                        const Vec3 x = world.restPosition(kCorners * c + corner);
                        ends.push_back({x[0], x[1], x[2]});
                    }
                std::sort(ends.begin(), ends.end());
                return ends;
            };
            REQUIRE(diagonal(cell, 1).size() == 2);
            REQUIRE(diagonal(cell, 1) == diagonal(other, 0));
        }
}

TEST_CASE("corner tetrahedra start with their apex and fill the cell") {
    for (const auto& split : kTetrahedra) {
        int volume = 0;
        for (int t = 0; t < 5; ++t) {
            Eigen::Matrix3i edges;
            for (int i = 0; i < 3; ++i)
                for (int axis = 0; axis < 3; ++axis)
                    edges(axis, i) = (split[t][i + 1] >> axis & 1) - (split[t][0] >> axis & 1);
            const int determinant = edges.cast<double>().determinant() > 0 ? (t < 4 ? 1 : 2) : -100;
            CHECK(edges.cast<double>().determinant() == Approx(determinant));
            volume += determinant;
            if (t < 4)
                for (int i = 1; i < 4; ++i) {
                    const int edge = split[t][i] ^ split[t][0];
                    CHECK((edge == 1 || edge == 2 || edge == 4));
                }
        }
        CHECK(volume == 6);
    }
}

TEST_CASE("masses add up to density times volume, and a joined group's to its members'") {
    WorldDescription description = block({7, 5, 3}, softElastic());
    Material heavy = softElastic();
    heavy.density = 3000;
    description.materials.push_back(heavy);
    description.bodies[0].regions = {{{0, 0, 0}, {6, 0, 2}, 1}, {{6, 4, 2}, {6, 4, 2}, -1}};
    const World world(description);
    CHECK(world.presentCells() == 104);
    double mass = 0;
    for (int node = 0; node < world.nodeCount(); ++node) mass += world.nodeMass(node);
    CHECK(mass == Approx((83 * 1000 + 21 * 3000) * 0.001));
    // An inner lattice point between the two materials: four eighths of each.
    const State state = world.initialState();
    const int cell = world.bodies()[0].cellAt({2, 0, 0}), corner = 7;
    double group = 0;
    int members = 0;
    for (int octant = 0; octant < 8; ++octant)
        if (linkMask(heldBonds(world, state, cell, corner), 0) >> octant & 1) {
            ++members;
            group +=
                world.nodeMass(kCorners * cellInOctant(world, cell, corner, octant) + (octant ^ 7));
        }
    CHECK(members == 8);
    CHECK(group == Approx((4 * 1000 + 4 * 3000) * 0.001 / 8));
    // Drag and gravity of a body: weighted by mass.
    CHECK(world.bondCount() == 6 * 5 * 3 + 7 * 4 * 3 + 7 * 5 * 2 - 3);
}

TEST_CASE("a body is turned about the centre of its bottom face, with all that belongs to it") {
    WorldDescription description = block({5, 4, 3}, brittle());
    description.bodies[0].size = {1, 0.6, 0.3};
    description.bodies[0].position = {2, 3, -1};
    description.bodies[0].anchors = {Side::Left};
    EventDescription event = hit(0, {0.35, 0.4, 0.1}, {1, 0, 0});
    event.radius = 0.2;
    description.events = {event};
    const World upright(description);
    Random random(7);
    for (int trial = 0; trial < 5; ++trial) {
        const Mat3 turn = random.rotation();
        description.bodies[0].orientation = turn;
        const World world(description);
        const Body& body = world.bodies()[0];
        CHECK(body.turned);
        CHECK((body.axes - turn).norm() < 1e-14);
        const Vec3 about(2, 3, -1);
        Vec3 low = Vec3::Constant(1e9), high = -low;
        for (int node = 0; node < world.nodeCount(); ++node) {
            const Vec3 x = world.restPosition(node);
            const Vec3 expected = about + turn * (upright.restPosition(node) - about);
            // Both are rounded to single precision, at coordinates of up to 4 m.
            REQUIRE((x - expected).norm() < 1e-6);
            REQUIRE(world.anchored(node) == upright.anchored(node));
            for (const double c : x) REQUIRE(c == static_cast<double>(static_cast<float>(c)));
            REQUIRE(insidePatch(world.events()[0], x.cast<float>()) ==
                    insidePatch(upright.events()[0], upright.restPosition(node).cast<float>()));
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
        CHECK((body.bounds().low - low).norm() < 1e-6);
        CHECK((body.bounds().high - high).norm() < 1e-6);
        CHECK(world.events()[0].acceleration == upright.events()[0].acceleration);
        for (int bond = 0; bond < world.bondSlots(); ++bond)
            REQUIRE(world.bondStrength(bond) == upright.bondStrength(bond));
    }
}

TEST_CASE("a quarter turn is exact, however its angles are rounded") {
    WorldDescription description = block({2, 3, 1}, softElastic());
    for (const double angle :
         {std::numbers::pi / 2, 1.5707963267948966, -3 * std::numbers::pi / 2}) {
        description.bodies[0].orientation = Eigen::AngleAxisd(angle, Vec3::UnitY());
        const World world(description);
        const Body& body = world.bodies()[0];
        CHECK(body.axes.col(0) == Vec3(0, 0, -1));
        CHECK(body.axes.col(1) == Vec3(0, 1, 0));
        CHECK(body.axes.col(2) == Vec3(1, 0, 0));
        for (int corner : {0, 1, 4, 5}) CHECK(world.restPosition(corner)[1] == 0);
    }
    // Once round, or the same quaternion with the other sign, is no turn.
    for (const double angle : {0., 2 * std::numbers::pi, 4 * std::numbers::pi}) {
        description.bodies[0].orientation = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized());
        CHECK(!World(description).anyTurned());
    }
}

TEST_CASE("anchored sides hold exactly the nodes on them") {
    for (const Side side :
         {Side::Left, Side::Right, Side::Bottom, Side::Top, Side::Back, Side::Front}) {
        WorldDescription description = block({4, 3, 2}, softElastic());
        description.bodies[0].anchors = {side};
        const World world(description);
        const int axis = static_cast<int>(side) / 2;
        const double plane = world.bodies()[0].origin[axis] +
                             (static_cast<int>(side) % 2 ? description.bodies[0].size[axis] : 0);
        for (int node = 0; node < world.nodeCount(); ++node)  // rest positions are single-precision
            REQUIRE(world.anchored(node) ==
                    (std::abs(world.restPosition(node)[axis] - plane) < 1e-6));
    }
}

TEST_CASE("the count of pieces is right on cases made by hand") {
    const World world(block({3, 3, 1}, softElastic()));
    State state = world.initialState();
    CHECK(findPieces(world, state).count == 1);
    // Column 0 | columns 1–2: three bonds. Two of them are not enough.
    breakBond(state, 0, 0);
    breakBond(state, 3, 0);
    CHECK(findPieces(world, state).count == 1);
    breakBond(state, 6, 0);
    CHECK(findPieces(world, state).count == 2);
    // The middle cell loses its remaining three neighbours.
    detach(world, state, 4);
    const Pieces pieces = findPieces(world, state);
    CHECK(pieces.count == 3);
    CHECK(pieces.ofCell == std::vector<int>{0, 1, 1, 0, 2, 1, 0, 1, 1});

    // Two bodies, one with a hole that cuts it in two, never hang together.
    WorldDescription description = block({5, 1, 1}, softElastic());
    description.bodies.push_back(description.bodies[0]);
    description.bodies[0].regions = {{{2, 0, 0}, {2, 0, 0}, -1}};
    const World two(description);
    CHECK(findPieces(two, two.initialState()).count == 3);
    CHECK(two.bondCount() == 2 + 4);
}

TEST_CASE("octants and bonds around a lattice point") {
    for (int bond = 0; bond < 12; ++bond) CHECK((bondOctant(bond) >> bond / 4 & 1) == 0);
    CHECK(linkMask(0, 5) == 1 << 5);
    CHECK(linkMask(0xfff, 3) == 0xff);
    CHECK(linkMask(1u << 0, 0) == 0b11);                  // x bond of octant 0
    CHECK(linkMask(1u << 4, 0) == 0b101);                 // y bond of octant 0
    CHECK(linkMask(1u << 8, 4) == 0b10001);               // z bond of octant 0
    CHECK(linkMask(1u << 8 | 1u << 3, 7) == 0b11000000);  // octants 6–7, and 0–4 apart
}

TEST_CASE("strengths: mean, spread, axes, boundaries, seeds") {
    Material m = brittle();
    m.strength = {3e5, 9e5, 3e5};
    m.boundaryStrength = {1e5, 1e5, 1e5};
    m.spread = 0.3;
    double sum = 0, squares = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
        const double s = bondStrength(m, {0, 0, 0}, {0, 0.1, 0}, 1, i, 7) / 9e5;
        REQUIRE(s >= 0.25);
        REQUIRE(s <= 3);
        sum += s;
        squares += s * s;
    }
    // Weibull of modulus 4: mean 1, standard deviation 0.28; 20,000 draws know the mean to 0.002.
    CHECK(sum / n == Approx(1).epsilon(0.01));
    CHECK(std::sqrt(squares / n - sum / n * sum / n) == Approx(0.2805).epsilon(0.05));

    m.spread = 0;
    m.clusters = ClusterKind::Planks;
    m.clusterSize = {0.2, 1, 1};
    CHECK(bondStrength(m, {0.05, 0, 0}, {0.15, 0, 0}, 0, 1, 7) == 3e5);
    CHECK(bondStrength(m, {0.15, 0, 0}, {0.25, 0, 0}, 0, 1, 7) == 1e5);
    m.clusters = ClusterKind::RunningBond;
    m.clusterSize = {0.4, 0.2, 1};
    CHECK(clusterOf(m, {0.35, 0.1, 0}, 7) != clusterOf(m, {0.45, 0.1, 0}, 7));
    CHECK(clusterOf(m, {0.35, 0.3, 0}, 7) ==
          clusterOf(m, {0.45, 0.3, 0}, 7));  // the next course is shifted by half a brick
    CHECK(clusterOf(m, {0.15, 0.3, 0}, 7) != clusterOf(m, {0.25, 0.3, 0}, 7));

    WorldDescription description = block({10, 10, 1}, brittle());
    const World a(description), again(description);
    description.seed = 2;
    const World b(description);
    description.bodies.push_back(description.bodies[0]);
    const World twice(description);
    int changed = 0, differs = 0;
    for (int bond = 0; bond < a.bondSlots(); ++bond) {
        REQUIRE(a.bondStrength(bond) == again.bondStrength(bond));
        changed += a.bondStrength(bond) != b.bondStrength(bond);
        differs += twice.bondStrength(bond) != twice.bondStrength(bond + a.bondSlots());
    }
    CHECK(changed == a.bondCount());
    CHECK(differs == a.bondCount());  // two copies of a wall are two walls
}

TEST_CASE("a world that no solver could hold in memory is refused with what would fit") {
    const std::uint64_t megabyte = 1'000'000;
    CHECK_THROWS_AS(requireMemory(kMaxCells, 8000 * megabyte), InputError);
    try {
        requireMemory(kMaxCells, 8000 * megabyte);
    } catch (const InputError& error) {
        const std::string said = error.what();
        CHECK(said.find("16777216 cells take at least 19.3 GB, and there are 8.0 GB") !=
              std::string::npos);
        const std::size_t number = said.find("use at most ") + 12;
        REQUIRE(number < said.size());
        const std::int64_t most = std::stoll(said.substr(number));
        CHECK_NOTHROW(requireMemory(most, 8000 * megabyte));
        CHECK_THROWS_AS(requireMemory(most + 1, 8000 * megabyte), InputError);
    }
    CHECK_NOTHROW(requireMemory(1, megabyte));
    // More than nothing, less than any machine has: neither a failed question nor wrapped around.
    CHECK(usableMemory() > 100 * megabyte);
    CHECK(usableMemory() < (std::uint64_t{1} << 60));
}

TEST_CASE("what a world cannot be becomes one sentence") {
    WorldDescription huge = block({4000, 4000, 4000}, softElastic());
    CHECK_THROWS_WITH(World(huge), Catch::Contains("too large") && Catch::Contains("16777216"));
    WorldDescription empty = block({2, 2, 2}, softElastic());
    empty.bodies[0].regions = {{{0, 0, 0}, {1, 1, 1}, -1}};
    CHECK_THROWS_WITH(World(empty), Catch::Contains("no cells left"));
    WorldDescription miss = block({2, 2, 2}, softElastic());
    miss.bodies[0].name = "block";
    EventDescription event;
    event.where = "walls.toml:9: event 1";
    event.point = {5, 0, 0};
    miss.events = {event};
    CHECK_THROWS_WITH(World(miss),
                      Catch::StartsWith("walls.toml:9: event 1: no free node of body 'block'"));
    WorldDescription many = block({1, 1, 1}, softElastic());
    for (int i = 0; i < 300; ++i) {
        many.bodies.push_back(many.bodies[0]);
        many.bodies.back().size *= 1 + 0.01 * i;
    }
    CHECK_THROWS_WITH(World(many), Catch::Contains("256 combinations"));
}

TEST_CASE("the state hash sees every bit of every node") {
    const World world(block({2, 2, 2}, softElastic()));
    State state = world.initialState();
    const std::uint64_t hash = stateHash(state);
    CHECK(hash == stateHash(world.initialState()));
    state.velocity.back()[2] = 1e-30;
    CHECK(stateHash(state) != hash);
}

TEST_CASE("energies and momenta of simple states") {
    WorldDescription description = block({3, 2, 1}, softElastic());
    description.gravity = {0, -10, 0};
    const World world(description);
    State state = world.initialState();
    CHECK(diagnose(world, state).gravity == Approx(6 * 10 * 0.1));  // 6 kg, centre of mass at 0.1 m
    for (Vec3& v : state.velocity) v = {3, 0, 4};
    // A uniform stretch of 1 % along x: ½(λ + 2μ)ε² per volume (corotated law).
    for (int node = 0; node < world.nodeCount(); ++node)
        state.displacement[node][0] = 0.01 * world.restPosition(node)[0];
    const Diagnostics d = diagnose(world, state);
    CHECK(d.kinetic == Approx(0.5 * 6 * 25));
    CHECK((d.momentum - Vec3(18, 0, 24)).norm() < 1e-9);
    CHECK(d.maxSpeed == Approx(5));
    const double modulus = 1e6 * 0.7 / (1.3 * 0.4);
    CHECK(d.elastic == Approx(0.5 * modulus * 1e-4 * 0.006));
    state.velocity[5][1] = std::nan("");
    CHECK(diagnose(world, state).nan == 1);
}
