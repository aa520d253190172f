// The lowest natural frequencies of a standing block, from its free vibration, against CalculiX.
#include <Eigen/Core>
#include <complex>
#include <numbers>

#include "catch.hpp"
#include "physics/calculix.hpp"
#include "physics/physics_worlds.hpp"
#include "physics/report.hpp"

using namespace sunder;

namespace {

constexpr int kModes = 3;
constexpr double kLookEvery = 4;  // steps, a hundred looks at a period of the slowest mode

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

}  // namespace

TEST_CASE("the first three natural frequencies of a block are CalculiX's") {
    const std::string calculix = calculixVersion();
    PhysicsReport report("natural-frequencies", "Natural frequencies of a block",
                         "A block of 0.4 × 1.2 × 0.5 m held at its bottom is hit at an edge and "
                         "rings; the first three peaks of its spectrum against *FREQUENCY of " +
                             calculix + " on the same mesh of linear tetrahedra");
    WorldDescription description = elasticBlock({4, 12, 5}, 0.1, 1.5e7, 0.3);
    description.bodies[0].anchors = {Side::Bottom};
    EventDescription hit;  // off every axis, so that it bends both ways and twists
    hit.kind = EventDescription::Kind::Velocity;
    hit.point = {0.2, 1.2, 0.25};
    hit.radius = 0.25;
    hit.vector = {0.2, 0, 0.2};  // m/s: strains of about a thousandth
    description.events = {hit};
    const World world(description);
    requireUnlimited(world);
    // Consistent mass there, lumped here: 1D elements of edge ℓ differ by (kℓ)²/12 in frequency,
    // 0.4 % of torsion, a quarter of a wave on 12 cells...
    const std::vector<double> expected =
        calculixFrequencies("frequencies", joinedMesh(world), description.materials[0], kModes);
    const int cells = world.cellCount();
    const int corners[] = {kCorners * (cells - 1) + 7, kCorners * (cells - 4) + 6};
    auto plot =
        report.plot("Spectrum of free vibration", {"frequency", "Hz"}, {"power", "m²", true});
    for (const SolverUnderTest& under : cpuSolvers()) {
        const auto solver = under.make(world);
        Record record(6);
        const double interval = kLookEvery * world.step();
        // 16 periods of the slowest mode.
        solver->advance(20);
        while (interval * static_cast<double>(record[0].size()) < 16 / expected[0]) {
            solver->advance(static_cast<int>(kLookEvery));
            const State state = solver->state();
            for (int i = 0; i < 6; ++i)
                record[i].push_back(state.displacement[corners[i / 3]][i % 3]);
        }
        const PlotPoints points = spectrum(record, interval, 1.3 * expected.back());
        plot.series(under.name, LineStyle::Line, points);
        const std::vector<double> found = peaks(points);
        CAPTURE(under.name, found, expected);
        REQUIRE(found.size() >= kModes);
        for (int mode = 0; mode < kModes; ++mode)
            report.checkRelative("frequency " + std::to_string(mode + 1) + ", " + under.name,
                                 found[mode], expected[mode], "Hz", 0.02);
    }
}
