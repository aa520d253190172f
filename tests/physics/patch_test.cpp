// Patch test (Irons; Hughes, The Finite Element Method, section 4.6): a uniform deformation gives
// one stress everywhere and forces on the surface alone, whatever the mesh. Sunder's meshes are
// lattices, so irregular means here: oblong cells, both mirrored splits, holes.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <map>

#include "catch.hpp"
#include "core/elasticity.hpp"
#include "physics/joined_mesh.hpp"
#include "physics/physics_worlds.hpp"
#include "physics/report.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

const Vec3 kCell(0.08, 0.1, 0.13);  // m
constexpr double kYoungModulus = 1e6, kPoissonRatio = 0.3;

/// F = Q·(I + S): a rotation by half a radian after a stretch of some per cent.
const Mat3 kRotation = Eigen::AngleAxisd(0.5, Vec3(1, 2, -2).normalized()).toRotationMatrix();
const Mat3 kStrain =
    (Mat3() << 0.03, 0.01, -0.005, 0.01, -0.02, 0.015, -0.005, 0.015, 0.01).finished();
const Mat3 kGradient = kRotation * (Mat3::Identity() + kStrain);

/// First Piola–Kirchhoff stress, Pa.
Mat3 closedForm(ConstitutiveLaw law) {
    const double mu = kYoungModulus / (2 * (1 + kPoissonRatio));
    const double lambda = 2 * mu * kPoissonRatio / (1 - 2 * kPoissonRatio);
    const auto linear = [&](const Mat3& strain) -> Mat3 {
        return 2 * mu * strain + lambda * strain.trace() * Mat3::Identity();
    };
    if (law == ConstitutiveLaw::Corotated) return kRotation * linear(kStrain);
    return kGradient * linear(kStrain + 0.5 * kStrain * kStrain);  // ½(FᵀF − I)
}

WorldDescription oblongBlock(IVec3 cells, ConstitutiveLaw law) {
    WorldDescription description = elasticBlock(cells, 1, kYoungModulus, kPoissonRatio);
    description.bodies[0].size = kCell.cwiseProduct(cells.cast<double>());
    description.materials[0].law = law;
    return description;
}

State uniformState(const World& world) {
    State state = world.initialState();
    for (int node = 0; node < world.nodeCount(); ++node)
        state.displacement[node] = (kGradient - Mat3::Identity()) * latticePosition(world, node);
    return state;
}

/// Pa. A displacement of U m is rounded to ε·U; differences of two, over the shortest edge ℓ, and
/// F ≈ 1 itself make ε·(1 + 2U/ℓ) of F. Three columns add up, and moduli are below 2μ + 3λ.
double stressRounding(const World& world, const State& state, double epsilon) {
    double largest = 0;
    for (const Vec3& u : state.displacement) largest = std::max(largest, u.norm());
    const ElementLaw& law = world.laws()[0];
    return 3 * epsilon * (1 + 2 * largest / kCell.minCoeff()) * (2 * law.mu + 3 * law.lambda);
}

/// N, on each joined point, from the speed that one step gives to it.
std::vector<Vec3> pointForces(const World& world, const JoinedMesh& mesh, Solver& solver,
                              const State& state) {
    solver.setState(state);
    solver.advance(1);
    const State after = solver.state();
    std::vector<Vec3> force(mesh.points.size(), Vec3::Zero());
    for (int node = 0; node < world.nodeCount(); ++node)
        if (mesh.pointOf[node] >= 0)
            force[mesh.pointOf[node]] += world.nodeMass(node) * after.velocity[node] / world.step();
    return force;
}

/// m², per point: a third of the outward area of each surface triangle it belongs to. Zero inside.
std::vector<Vec3> surfaceAreas(const JoinedMesh& mesh) {
    std::map<std::array<int, 3>, Vec3> surface;
    for (const auto& [a, b, c, d] : mesh.tetrahedra)
        for (std::array<int, 3> face : {std::array{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}}) {
            const auto& x = mesh.points;
            const Vec3 area = 0.5 * (x[face[1]] - x[face[0]]).cross(x[face[2]] - x[face[0]]);
            std::sort(face.begin(), face.end());
            if (!surface.emplace(face, area).second) surface.erase(face);
        }
    std::vector<Vec3> areas(mesh.points.size(), Vec3::Zero());
    for (const auto& [face, area] : surface)
        for (const int point : face) areas[point] += area / 3;
    return areas;
}

/// Pa, of each present cell, all of them apart: P = −Σ f⊗X / V over a cell's own corners.
std::vector<Mat3> cellStresses(const World& world, Solver& solver, State state) {
    for (double& damage : state.damage) damage = std::max(damage, 1.0);
    solver.setState(state);
    solver.advance(1);
    const State after = solver.state();
    std::vector<Mat3> stresses;
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (!world.present(cell)) continue;
        Mat3 sum = Mat3::Zero();
        for (int corner = 0; corner < kCorners; ++corner) {
            const int node = kCorners * cell + corner;
            sum += world.nodeMass(node) / world.step() * after.velocity[node] *
                   world.cornerOffset(cell, corner).transpose();
        }
        stresses.push_back(-sum / kCell.prod());
    }
    return stresses;
}

/// A logarithmic axis has no zero.
double onLogAxis(double x) {
    return std::max(x, 1e-18);
}

}  // namespace

TEST_CASE("patch test: a uniform deformation gives one stress and no force inside") {
    PhysicsReport report(
        "patch-test", "Patch test",
        "Stress of every cell and force on every point of a block with holes "
        "under a uniform finite deformation, against the closed form "
        "P = Q·(2μS + λ·tr(S)·I) and the surface's share of it (Irons' patch test)");
    auto stressPlot = report.plot("Error of stress, cell by cell (corotated law)", {"cell", "1"},
                                  {"error over stress", "1", true});
    auto forcePlot = report.plot("Force on each point, in ascending order (corotated law)",
                                 {"point", "1"}, {"force", "N", true});
    for (const ConstitutiveLaw law : {ConstitutiveLaw::Corotated, ConstitutiveLaw::Green}) {
        WorldDescription description = oblongBlock({6, 5, 4}, law);
        description.bodies[0].regions = {{{2, 2, 1}, {2, 3, 2}, -1}, {{5, 0, 0}, {5, 1, 3}, -1}};
        const World world(description);
        requireUnlimited(world);
        const JoinedMesh mesh = joinedMesh(world);
        const std::vector<Vec3> areas = surfaceAreas(mesh);
        const State state = uniformState(world);
        const Mat3 expected = closedForm(law);
        const bool plotted = law == ConstitutiveLaw::Corotated;
        for (const SolverUnderTest& under : allSolvers()) {
            const std::string which = ", " + std::string(toString(law)) + ", " + under.name;
            const auto solver = under.make(world);
            const double rounding = stressRounding(world, state, under.epsilon);

            double stressError = 0;
            PlotPoints errors, forces;
            for (const Mat3& stress : cellStresses(world, *solver, state)) {
                const double error = (stress - expected).norm();
                stressError = std::max(stressError, error);
                errors.push_back(
                    {static_cast<double>(errors.size()), onLogAxis(error / expected.norm())});
            }
            double inside = 0, surface = 0;
            const std::vector<Vec3> force = pointForces(world, mesh, *solver, state);
            for (std::size_t point = 0; point < force.size(); ++point) {
                double& worst = areas[point].norm() < 1e-12 ? inside : surface;
                worst = std::max(worst, (force[point] + expected * areas[point]).norm());
                forces.push_back({0, onLogAxis(force[point].norm())});
            }
            std::sort(forces.begin(), forces.end());
            for (std::size_t i = 0; i < forces.size(); ++i) forces[i][0] = static_cast<double>(i);
            if (plotted) {
                stressPlot.series(under.name, LineStyle::Points, errors);
                forcePlot.series(under.name, LineStyle::Points, forces);
            }
            report.checkAbsolute("largest error of a cell's stress" + which, stressError, 0, "Pa",
                                 rounding);
            // Eight cells around a point, each with a quarter of its largest face's area.
            const double area = 8 * 0.25 * kCell[1] * kCell[2];
            report.checkAbsolute("largest force on a point inside" + which, inside, 0, "N",
                                 area * rounding);
            report.checkAbsolute("largest error of a force on the surface" + which, surface, 0, "N",
                                 area * rounding);
        }
    }
}

TEST_CASE("patch test: points inside find the uniform deformation that the sides have") {
    PhysicsReport report("patch-test-relaxed", "Patch test with only the sides held",
                         "All six sides of a block are held in a uniform finite deformation, the "
                         "points inside are shaken and let go; they must come to rest where the "
                         "closed form u = (F − I)·x has them");
    auto plot = report.plot("Distance of the farthest point from its place", {"time", "s"},
                            {"distance over cell edge", "1", true});
    WorldDescription description = oblongBlock({5, 4, 3}, ConstitutiveLaw::Corotated);
    description.materials[0].damping = 300;  // critical for the slowest waves across four cells
    description.bodies[0].anchors = {Side::Left, Side::Right, Side::Bottom,
                                     Side::Top,  Side::Back,  Side::Front};
    keepAwake(description);
    const World world(description);
    requireUnlimited(world);
    const State expected = uniformState(world);
    State shaken = expected;
    const JoinedMesh mesh = joinedMesh(world);
    Random random(1);
    std::vector<Vec3> shift;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) shift.push_back(0.1 * random.vector());
    double largest = 0;
    for (int node = 0; node < world.nodeCount(); ++node) {
        largest = std::max(largest, expected.displacement[node].norm());
        if (const int point = mesh.pointOf[node]; !mesh.anchored[point])
            shaken.displacement[node] += shift[point].cwiseProduct(kCell);
    }
    const double edge = kCell.minCoeff();
    for (const SolverUnderTest& under : allSolvers()) {
        const auto solver = under.make(world);
        solver->setState(shaken);
        PlotPoints distance{
            {0, largestDifference(shaken.displacement, expected.displacement) / edge}};
        for (int i = 1; i <= 60; ++i) {
            solver->advance(25);
            distance.push_back(
                {25 * i * world.step(),
                 onLogAxis(largestDifference(solver->state().displacement, expected.displacement) /
                           edge)});
        }
        plot.series(under.name, LineStyle::Line, distance);
        // Motion ends where a step's h·v is below ε·U/2, half a bit of the displacement: with drag
        // d that is d·ε·U/(2h·ω²) off, ω ≈ 1/(10·h) for five cells across. Forces are rounded, too:
        // ten times as much in all.
        const double rounding =
            10 * under.epsilon * largest *
            std::max(1.0, 100 * description.materials[0].damping * world.step() / 2);
        report.checkAbsolute("distance from the closed form at the end, " + under.name,
                             distance.back()[1] * edge, 0, "m", rounding);
    }
}
