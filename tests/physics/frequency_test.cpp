// The lowest natural frequencies of bodies that stand, from their free vibration, against CalculiX.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "catch.hpp"
#include "physics/calculix.hpp"
#include "physics/physics_worlds.hpp"
#include "physics/report.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

constexpr int kModes = 3;
constexpr int kLookEvery = 4;  // steps, a hundred looks or more at a period of the slowest mode
/// Against CalculiX with its consistent mass. Lumped masses make frequencies lower, with cells of
/// edge ℓ by about (kℓ)²/12 along the bar, k = 4.7/2 m for mode 3, and as much again for the
/// turning of cross-sections of two cells: 1 %. Twice that.
constexpr double kConsistent = 0.02;
/// Against CalculiX with the same masses. The step raises a frequency by (ωh)²/24, 1e-5; samples of
/// the spectrum are a quarter of 1/length apart, 2 % of the lowest frequency, and a parabola finds
/// a peak to a quarter of that.
constexpr double kSameMasses = 0.005;
constexpr double kPeriods = 12;  // of the slowest mode: others 1.3 times as fast stand apart

/// Displacements, m, of two corners of the top, one series per component.
using Record = std::vector<std::vector<double>>;

/// How much of frequency f there is in all series together: power of the Fourier transform under
/// Blackman's window, whose side lobes are 58 dB down. `interval`: s.
double power(const Record& record, double interval, double f) {
    double sum = 0;
    for (const std::vector<double>& series : record) {
        std::complex<double> transform = 0;
        const auto n = static_cast<double>(series.size());
        for (std::size_t i = 0; i < series.size(); ++i) {
            const double phase = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / n;
            const double window = 0.42 - 0.5 * std::cos(phase) + 0.08 * std::cos(2 * phase);
            transform +=
                window * series[i] *
                std::polar(1.0, -2 * std::numbers::pi * f * interval * static_cast<double>(i));
        }
        sum += std::norm(transform / n);
    }
    return sum;
}

PlotPoints spectrum(const Record& record, double interval, double highest) {
    const double length = interval * static_cast<double>(record[0].size());
    PlotPoints points;
    for (double f = 3 / length; f < highest; f += 0.25 / length)
        points.push_back({f, power(record, interval, f)});
    return points;
}

/// Hz: the lowest peaks that rise out of the side lobes, by a parabola through the logarithm of
/// three samples, a quarter of 1/length apart.
std::vector<double> peaks(const PlotPoints& points) {
    double largest = 0;
    for (const auto& [f, p] : points) largest = std::max(largest, p);
    std::vector<double> found;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const double p = points[i][1];
        if (p < 1e-5 * largest || p < points[i - 1][1] || p < points[i + 1][1]) continue;
        const double a = std::log(points[i - 1][1]), b = std::log(p),
                     c = std::log(points[i + 1][1]);
        found.push_back(points[i][0] +
                        0.5 * (a - c) / (a - 2 * b + c) * (points[1][0] - points[0][0]));
    }
    return found;
}

/// Held at its bottom, and hit at a corner of its top, off every axis, so that it bends both ways
/// and twists.
WorldDescription standing(IVec3 cells, double cell) {
    WorldDescription description = elasticBlock(cells, cell, 1.5e7, 0.3);
    BodyDescription& body = description.bodies[0];
    body.anchors = {Side::Bottom};
    EventDescription hit;
    hit.kind = EventDescription::Kind::Velocity;
    hit.point = {body.size[0] / 2, body.size[1], body.size[2] / 2};
    hit.radius = 0.25;
    hit.vector = {0.2, 0, 0.2};  // m/s: strains of about a thousandth
    description.events = {hit};
    return description;
}

/// Power over frequency of what a block does after the hit, for `length` s.
PlotPoints ring(const SolverUnderTest& under, const World& world, double length, double highest) {
    requireUnlimited(world);
    const auto solver = under.make(world);
    const IVec3 cells = world.bodies()[0].cells;
    const int ends[] = {world.bodies()[0].cellAt({cells[0] - 1, cells[1] - 1, cells[2] - 1}),
                        world.bodies()[0].cellAt({0, cells[1] - 1, cells[2] - 1})};
    const int corners[] = {kCorners * ends[0] + 7, kCorners * ends[1] + 6};
    const double interval = kLookEvery * world.step();
    Record record(6);
    solver->advance(static_cast<int>(0.01 / world.step()));  // the hit takes 5 ms
    for (double t = 0; t < length; t += interval) {
        solver->advance(kLookEvery);
        const State state = solver->state();
        for (int i = 0; i < 6; ++i) record[i].push_back(state.displacement[corners[i / 3]][i % 3]);
    }
    REQUIRE_FALSE(solver->asleep(0));
    return spectrum(record, interval, highest);
}

/// Marks frequencies on a spectrum.
PlotPoints onCurve(const PlotPoints& points, const std::vector<double>& frequencies) {
    PlotPoints marks;
    for (const double f : frequencies)
        marks.push_back(
            {f, (*std::lower_bound(points.begin(), points.end() - 1, std::array{f, 0.0}))[1]});
    return marks;
}

}  // namespace

TEST_CASE("the first three natural frequencies of a bar are CalculiX's", "[calculix]") {
    PhysicsReport report(
        "natural-frequencies", "Natural frequencies of a bar",
        "A bar of 0.2 × 2 × 0.3 m held at its bottom is hit at a corner and "
        "rings; the first three peaks of its spectrum against *FREQUENCY of CalculiX "
        "on the same mesh of linear tetrahedra, with its consistent mass and with "
        "Sunder's masses at the points");
    const World world(standing({2, 20, 3}, 0.1));
    const JoinedMesh mesh = joinedMesh(world);
    const Material& material = world.description().materials[0];
    const std::vector<double> expected =
        calculixFrequencies(report, "bar", mesh, material, kModes, Mass::Consistent);
    const std::vector<double> lumped =
        calculixFrequencies(report, "bar-lumped", mesh, material, kModes, Mass::Lumped);
    auto plot =
        report.plot("Spectrum of free vibration", {"frequency", "Hz"}, {"power", "m²", true});
    PlotPoints points;
    for (const SolverUnderTest& under : allSolvers()) {
        // It would take longer in software than all else here; its masses and forces are those of
        // the wave and the sag.
        if (under.name == "scatter") continue;
        points = ring(under, world, kPeriods / expected[0], 1.3 * expected.back());
        plot.series(under.name, LineStyle::Line, points);
        const std::vector<double> found = peaks(points);
        CAPTURE(under.name, found, expected);
        REQUIRE(found.size() >= kModes);
        for (int mode = 0; mode < kModes; ++mode) {
            const std::string which = "frequency " + std::to_string(mode + 1) + ", " + under.name;
            report.checkRelative(which, found[mode], expected[mode], "Hz", kConsistent);
            report.checkRelative(which + ", same point masses", found[mode], lumped[mode], "Hz",
                                 kSameMasses);
        }
    }
    const std::string calculix = calculixVersion("bar");
    plot.series(calculix + ", consistent mass", LineStyle::Points, onCurve(points, expected));
    plot.series(calculix + ", same point masses", LineStyle::Points, onCurve(points, lumped));
}

TEST_CASE("the natural frequencies of a block, torsion among them, converge to CalculiX's",
          "[calculix]") {
    PhysicsReport report("block-frequencies", "Natural frequencies of a block as cells get smaller",
                         "A block of 0.4 × 1.2 × 0.6 m held at its bottom; bending both ways and "
                         "torsion against *FREQUENCY of CalculiX on the same mesh: the same with "
                         "Sunder's masses at the points; with its own consistent mass, which turns "
                         "more easily, they meet as cells get smaller");
    auto spectra =
        report.plot("Spectrum of free vibration", {"frequency", "Hz"}, {"power", "m²", true});
    auto errors = report.plot("Frequencies below CalculiX's with consistent mass",
                              {"cells over 0.4 m", "1", true}, {"difference", "1", true});
    const char* modes[kModes] = {"bending over 0.4 m", "bending over 0.6 m", "torsion"};
    std::array<PlotPoints, kModes> differences;
    const SolverUnderTest cpu = cpuSolvers().back();
    REQUIRE(cpu.name == "cpu");
    for (const int fineness : {2, 4, 5}) {
        WorldDescription description = standing(fineness * IVec3(2, 6, 3), 0.2 / fineness);
        description.step *= 2.0 / fineness;  // carries the same E
        const World world(description);
        const JoinedMesh mesh = joinedMesh(world);
        const std::string name = "block-" + std::to_string(2 * fineness);
        const auto consistent = calculixFrequencies(report, name, mesh, description.materials[0],
                                                    kModes, Mass::Consistent);
        const auto lumped = calculixFrequencies(report, name + "-lumped", mesh,
                                                description.materials[0], kModes, Mass::Lumped);
        const PlotPoints points = ring(cpu, world, kPeriods / lumped[0], 1.3 * lumped.back());
        const std::string across = std::to_string(2 * fineness) + " cells over 0.4 m";
        spectra.series(across, LineStyle::Line, points);
        const std::vector<double> found = peaks(points);
        CAPTURE(fineness, found, consistent, lumped);
        REQUIRE(found.size() >= kModes);
        for (int mode = 0; mode < kModes; ++mode) {
            differences[mode].push_back({2.0 * fineness, 1 - found[mode] / consistent[mode]});
            report.checkRelative(modes[mode] + std::string(", ") + across + ", same masses",
                                 found[mode], lumped[mode], "Hz", kSameMasses);
            if (fineness == 5)
                report.checkRelative(modes[mode] + std::string(", ") + across + ", consistent mass",
                                     found[mode], consistent[mode], "Hz", kConsistent);
        }
    }
    for (int mode = 0; mode < kModes; ++mode)
        errors.series(modes[mode], LineStyle::Points, differences[mode]);
    PlotPoints square;
    const auto [coarse, first] = differences.back()[0];
    for (const auto& point : differences.back())
        square.push_back({point[0], first * std::pow(coarse / point[0], 2)});
    errors.series("square of the edge", LineStyle::Dashed, square);
}
