// A pressure wave in a slender bar with ν = 0 travels at √(E/ρ), as d'Alembert's solution has it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "physics/physics_worlds.hpp"
#include "physics/report.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

constexpr int kCells = 160;
constexpr double kCell = 0.1, kYoungModulus = 2e7, kDensity = 1000;
constexpr double kPulse = 12 * kCell;  // m, half its length at the start
constexpr double kSpeed = 0.1;         // m/s: strains below a thousandth

/// Of the speed. Waves of length L in a row of point masses are slower by (π·cell/L)²/6, groups of
/// them by three times that: 0.9 % for the 24 cells of the hump.
constexpr double kDispersion = 0.01;

/// m/s, at x m from the middle of the bar at time 0: a smooth hump of velocity, nothing strained.
double hump(double x) {
    const double c = std::cos(0.5 * std::numbers::pi * x / kPulse);
    return std::abs(x) < kPulse ? kSpeed * c * c : 0;
}

/// Mean velocity along the bar (m/s) of each cross-section, against its place (m).
PlotPoints profile(const World& world, const State& state) {
    PlotPoints points(kCells + 1);
    std::vector<double> count(kCells + 1);
    for (int node = 0; node < world.nodeCount(); ++node) {
        const double x = latticePosition(world, node)[0];
        const auto section = static_cast<std::size_t>(std::lround(x / kCell + kCells / 2.0));
        points[section][0] = x;
        points[section][1] += state.velocity[node][0];
        ++count[section];
    }
    for (std::size_t i = 0; i < points.size(); ++i) points[i][1] /= count[i];
    return points;
}

/// m: mean place of the momentum right of the middle.
double centre(const PlotPoints& profile) {
    double sum = 0, moment = 0;
    for (const auto& [x, v] : profile)
        if (x > 0) {
            sum += v;
            moment += x * v;
        }
    return moment / sum;
}

/// m: the highest point right of the middle, by a parabola through three cross-sections.
double crest(const PlotPoints& profile) {
    std::size_t at = profile.size() / 2 + 1;
    for (std::size_t i = at; i + 1 < profile.size(); ++i)
        if (profile[i][1] > profile[at][1]) at = i;
    const double a = profile[at - 1][1], b = profile[at][1], c = profile[at + 1][1];
    return profile[at][0] + 0.5 * (a - c) / (a - 2 * b + c) * kCell;
}

}  // namespace

TEST_CASE("a pressure wave travels at the speed of sound of a bar") {
    PhysicsReport report("wave-speed", "Speed of a pressure wave",
                         "A hump of velocity in the middle of a free bar with ν = 0 splits and "
                         "runs both ways at √(E/ρ): d'Alembert's solution of the wave equation");
    WorldDescription description = elasticBlock({kCells, 2, 2}, kCell, kYoungModulus, 0);
    const World world(description);
    requireUnlimited(world);
    State start = world.initialState();
    for (int node = 0; node < world.nodeCount(); ++node)
        start.velocity[node] = {hump(latticePosition(world, node)[0]), 0, 0};
    const double speed = std::sqrt(kYoungModulus / kDensity);
    const auto steps = [&](double distance) {
        return static_cast<int>(std::lround(distance / (speed * world.step())));
    };
    // The two halves have parted at the first look, and none has reached an end at the second.
    const int first = steps(2 * kPulse), second = steps(kCells * kCell / 2 - 2 * kPulse);
    for (const SolverUnderTest& under : allSolvers()) {
        const auto solver = under.make(world);
        solver->setState(start);
        solver->advance(first);
        const PlotPoints early = profile(world, solver->state());
        solver->advance(second - first);
        const PlotPoints late = profile(world, solver->state());
        const double time = (second - first) * world.step();
        report.checkRelative("speed of the momentum's centre, " + under.name,
                             (centre(late) - centre(early)) / time, speed, "m/s", kDispersion);
        // Cells slow short waves down, so the crest lags a little.
        report.checkRelative("speed of the crest, " + under.name,
                             (crest(late) - crest(early)) / time, speed, "m/s", kDispersion);

        auto plot = report.plot("Velocity along the bar, " + under.name,
                                {"place, from the middle", "m"}, {"velocity", "m/s"});
        plot.series("start", LineStyle::Points, profile(world, start));
        for (const int step : {first, second}) {
            PlotPoints exact;
            for (const auto& [x, v] : early) {
                const double way = speed * step * world.step();
                exact.push_back({x, 0.5 * (hump(x - way) + hump(x + way))});
            }
            const std::string when = std::to_string(std::lround(1e3 * step * world.step())) + " ms";
            plot.series("d'Alembert, " + when, LineStyle::Line, exact);
            plot.series(under.name + ", " + when, LineStyle::Points, step == first ? early : late);
        }
    }
}
