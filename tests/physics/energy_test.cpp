// Energy ledger: what forces, gravity and strain at the start put in is kinetic, elastic, or
// dissipated. Every entry is summed up by itself, from the motion and a closed form; none is what
// the others leave.
//
// Not in the ledger, because the motion alone does not tell what they took: contact of cells and
// objects with its dampers and friction, friction of the ground, strongly deformed elements. None
// of them is at work here.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/elasticity.hpp"
#include "core/pieces.hpp"
#include "physics/physics_worlds.hpp"
#include "physics/report.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

constexpr double kYoungModulus = 4e6;  // Pa, a fifth of what the step carries or less

/// J, since the start.
struct Ledger {
    double events = 0, drag = 0, viscosity = 0, ground = 0;
    double kinetic = 0, elastic = 0, gravity = 0;  ///< now

    double held() const { return kinetic + elastic + gravity; }
    double spent() const { return drag + viscosity + ground; }
};

/// Kinetic, elastic and gravity's energy. Symplectic Euler's velocities are those half a step
/// before its displacements, so both are taken there.
void takeStock(const World& world, State state, Ledger& ledger) {
    for (int node = 0; node < world.nodeCount(); ++node)
        state.displacement[node] -= 0.5 * world.step() * state.velocity[node];
    const Diagnostics now = diagnose(world, state);
    ledger.kinetic = now.kinetic;
    ledger.elastic = now.elastic;
    ledger.gravity = now.gravity;
}

/// W: power of the viscous stress b·h·C:ε̇ at small strains, with the rates before a step in the
/// stress and those across it in the work.
double viscousPower(const World& world, const std::vector<Vec3>& before,
                    const std::vector<Vec3>& across) {
    constexpr double shares[kTetrahedraPerCell] = {1. / 6, 1. / 6, 1. / 6, 1. / 6, 1. / 3};
    double power = 0;
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        const ElementLaw& law = world.laws()[world.lawOf(cell)];
        const auto stressing = cellGradients(world, cell, before, 0);
        const auto working = cellGradients(world, cell, across, 0);
        for (int t = 0; t < kTetrahedraPerCell; ++t) {
            const Mat3 rate = 0.5 * (stressing[t] + stressing[t].transpose());
            const double density = 2 * law.mu * (rate.array() * working[t].array()).sum() +
                                   law.lambda * rate.trace() * working[t].trace();
            power += kDamping * world.step() * shares[t] * law.cellSize.prod() * density;
        }
    }
    return power;
}

/// What one step adds to the ledger.
void enterStep(const World& world, const State& before, const State& after, Ledger& ledger) {
    const double h = world.step();
    std::vector<Vec3> across(before.velocity.size());
    for (int node = 0; node < world.nodeCount(); ++node) {
        across[node] = 0.5 * (before.velocity[node] + after.velocity[node]);
        if (world.anchored(node)) continue;
        const double mass = world.nodeMass(node);
        // What comes down on the ground stops there.
        const double rest = world.restPosition(node)[1];
        if (world.description().ground && rest + before.displacement[node][1] > 0 &&
            rest + after.displacement[node][1] == 0)
            ledger.ground += 0.5 * mass * std::pow(before.velocity[node][1], 2);
        const double lost = 1 - std::exp(-world.bodies()[0].drag * h);
        ledger.drag += mass * lost * before.velocity[node].dot(across[node]);
        for (const Event& event : world.events())
            if (insidePatch(event, world.restPosition(node).cast<float>()))
                ledger.events +=
                    h * mass * event.weight(before.step) * event.acceleration.dot(across[node]);
    }
    ledger.viscosity += h * viscousPower(world, before.velocity, across);
}

struct Course {
    std::vector<double> times;  ///< s
    std::vector<Ledger> entries;
    State end;
};

Course follow(const SolverUnderTest& under, const World& world, const State& start, int steps) {
    requireUnlimited(world);
    const auto solver = under.make(world);
    solver->setState(start);
    Course course;
    Ledger ledger;
    State before = solver->state();
    const int every = std::max(1, steps / 400);  // as often as a plot takes it
    for (int step = 0;; ++step) {
        if (step % every == 0) {
            takeStock(world, before, ledger);
            course.times.push_back(step * world.step());
            course.entries.push_back(ledger);
        }
        if (step == steps) break;
        solver->advance(1);
        State after = solver->state();
        enterStep(world, before, after, ledger);
        before = std::move(after);
    }
    course.end = before;
    return course;
}

/// Of what was turned over, the gap there may be. Symplectic Euler's energy is off by up to (ωh)²/4
/// of what a wave has: 0.06 % where a bar of few modes is hit, 0.7 % where a landing or a break
/// makes waves as short as cells are. Half as much again.
constexpr double kGap = 0.01;

/// J: by how much the books do not balance at worst.
double largestGap(const Course& course) {
    double worst = 0;
    for (const Ledger& l : course.entries)
        worst = std::max(worst,
                         std::abs(l.held() - course.entries.front().held() + l.spent() - l.events));
    return worst;
}

/// Plots the ledger and checks that it closes all the time. `turnover`: J, what 1 % is of.
void closeBooks(PhysicsReport& report, const std::string& story, const SolverUnderTest& under,
                const Course& course, double turnover) {
    const double start = course.entries.front().held();
    if (under.name == "cpu") {
        auto plot = report.plot(story, {"time", "s"}, {"energy", "J"});
        const double height = course.entries.front().gravity;
        const auto line = [&](const std::string& label, LineStyle style, const auto& entry) {
            PlotPoints points;
            for (std::size_t i = 0; i < course.times.size(); ++i)
                points.push_back({course.times[i], entry(course.entries[i])});
            const auto nothing = [](const auto& point) { return point[1] == 0; };
            if (!std::all_of(points.begin(), points.end(), nothing))
                plot.series(label, style, points);
        };
        line("kinetic", LineStyle::Line, [](const Ledger& l) { return l.kinetic; });
        line("elastic", LineStyle::Line, [](const Ledger& l) { return l.elastic; });
        line("gravity", LineStyle::Line, [&](const Ledger& l) { return l.gravity - height; });
        line("lost to drag", LineStyle::Line, [](const Ledger& l) { return l.drag; });
        line("lost to viscosity", LineStyle::Line, [](const Ledger& l) { return l.viscosity; });
        line("lost to the ground", LineStyle::Line, [](const Ledger& l) { return l.ground; });
        line("sum of these", LineStyle::Points,
             [&](const Ledger& l) { return l.held() - height + l.spent(); });
        line("put in", LineStyle::Dashed,
             [&](const Ledger& l) { return l.events + start - height; });
    }
    report.checkAbsolute(
        story + ": largest gap in the books over what was turned over, " + under.name,
        largestGap(course) / turnover, 0, "1", kGap);
}

WorldDescription heldBar(double drag) {
    WorldDescription description = elasticBlock({8, 2, 2}, 0.1, kYoungModulus, 0.3);
    description.bodies[0].anchors = {Side::Left};
    description.materials[0].damping = drag;
    keepAwake(description);
    return description;
}

EventDescription push(double force, double seconds) {
    EventDescription event;
    event.kind = EventDescription::Kind::Force;
    event.point = {0.4, 0.1, 0};
    event.radius = 0.16;
    event.duration = seconds;
    event.vector = {0, force, 0.5 * force};
    return event;
}

constexpr double kStrain = 0.004;

/// Between two anchors, with a cell in it that breaks at nine tenths of the stress there is.
WorldDescription stretchedBar(FractureMode mode) {
    WorldDescription description = elasticBlock({12, 1, 1}, 0.1, kYoungModulus, 0);
    description.bodies[0].anchors = {Side::Left, Side::Right};
    Material weak = description.materials[0];
    weak.fracture = mode;
    weak.maxStress = 0.9 * kYoungModulus * kStrain;
    weak.strength = weak.boundaryStrength = Vec3::Constant(weak.maxStress);
    weak.damageLength = 1e-3;
    description.materials.push_back(weak);
    description.bodies[0].regions = {{{5, 0, 0}, {5, 0, 0}, 1}};
    return description;
}

State stretched(const World& world) {
    State state = world.initialState();
    for (int node = 0; node < world.nodeCount(); ++node)
        state.displacement[node] = {kStrain * latticePosition(world, node)[0], 0, 0};
    return state;
}

}  // namespace

TEST_CASE("energy put in is kinetic, elastic, or dissipated") {
    PhysicsReport report("energy-ledger", "Energy ledger",
                         "Work of forces and gravity against kinetic and elastic energy and what "
                         "drag and viscosity take, each summed up by itself");
    for (const SolverUnderTest& under : allSolvers()) {
        for (const double drag : {0.0, 6.0}) {
            WorldDescription description = heldBar(drag);
            description.events.push_back(push(200, 0.01));
            const World world(description);
            const Course course = follow(under, world, world.initialState(), 2400);
            const Ledger& end = course.entries.back();
            closeBooks(report, drag == 0 ? "A bar is hit and rings" : "A bar is hit and rings down",
                       under, course, end.events);
            // It is the hit that put energy in, and drag that took it, where there is one.
            CHECK(end.events > 0.01);
            if (drag > 0) CHECK(end.drag > 0.9 * end.events);
        }
        WorldDescription description = heldBar(20);  // at rest within the second it is watched
        description.gravity = {0, -1, 0};
        const World world(description);
        const Course course = follow(under, world, world.initialState(), 3000);
        const double fallen = course.entries.front().gravity - course.entries.back().gravity;
        closeBooks(report, "A bar is let go and sags", under, course, fallen);
        // Let go at once, a spring keeps half of what gravity gives (Clapeyron's theorem). Its
        // motion has died out but for exp(−20/2·1 s); a law that is not linear makes as much as the
        // strain, 0.01 %. Ten times that.
        report.checkRelative(
            "A bar is let go and sags: elastic share of gravity's work, " + under.name,
            course.entries.back().elastic / fallen, 0.5, "1", 0.001);
    }
}

TEST_CASE("a landing costs the energy of what lands") {
    PhysicsReport report("energy-of-a-landing", "Energy of a fall on the ground",
                         "A block falls on a ground without friction; what reaches the ground "
                         "stops, and costs its kinetic energy, mv²/2");
    for (const SolverUnderTest& under : allSolvers()) {
        WorldDescription description = elasticBlock({4, 3, 2}, 0.1, kYoungModulus, 0.3);
        description.gravity = {0, -9.81, 0};
        description.ground = true;
        description.groundFriction = 0;
        description.bodies[0].position = {0, 0.1, 0};
        const World world(description);
        const Course course = follow(under, world, world.initialState(), 1600);
        const double fallen = world.presentCells() * world.cellMass(0) * 9.81 * 0.1;
        closeBooks(report, "A block falls 0.1 m on the ground", under, course, fallen);
    }
}

TEST_CASE("a break costs no energy: what was elastic moves the pieces") {
    PhysicsReport report("energy-of-a-break", "Energy of a break",
                         "A bar stretched between two anchors breaks at a weak cell; its elastic "
                         "energy, σ²/2E times the volume, becomes motion and then heat");
    for (const FractureMode mode : {FractureMode::Bond, FractureMode::Cell})
        for (const SolverUnderTest& under : allSolvers()) {
            const std::string story =
                "A stretched bar breaks, fracture = \"" + std::string(toString(mode)) + "\"";
            const World world(stretchedBar(mode));
            const Course course = follow(under, world, stretched(world), 800);
            const double stored = 0.5 * kYoungModulus * kStrain * kStrain * 1.2 * 0.1 * 0.1;
            // Displacements of up to ε·2.4 mm, over an edge and the strain: 1e-6 in single
            // precision, twice that in energy. Five times as much.
            report.checkRelative(story + ": energy at the start, " + under.name,
                                 course.entries.front().held(), stored, "J", 1e-5);
            closeBooks(report, story, under, course, stored);
            CHECK(findPieces(world, course.end).count > 1);
            double kinetic = 0;
            for (const Ledger& ledger : course.entries) kinetic = std::max(kinetic, ledger.kinetic);
            // All of it at the moment when each half has slackened, less what viscosity took from
            // the short waves of the break.
            CHECK(kinetic > 0.5 * stored);

            // What gap there is comes from the step: a break makes waves as short as cells are, and
            // of those symplectic Euler's energy is off by up to (ωh)²/4, a quarter at half the
            // step. Waves of different lengths die out differently with each step: hence the
            // tolerance.
            WorldDescription finer = stretchedBar(mode);
            finer.step /= 2;
            const World finerWorld(finer);
            const Course finerCourse = follow(under, finerWorld, stretched(finerWorld), 1600);
            report.checkAbsolute(story + ": the gap at half the step over that, " + under.name,
                                 largestGap(finerCourse) / largestGap(course), 0.25, "1", 0.1);
        }
}
