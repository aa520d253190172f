// "It never explodes": violent starts over all stiffnesses, Poisson's ratios and frame times.
// Prints a map of what was limited and what recovered.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <thread>
#include <vector>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "cpu/cpu_solver.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

enum class Start { Impact, Stretched, Scrambled, Mirrored, Noise };
constexpr std::pair<Start, const char*> kStarts[] = {{Start::Impact, "impact"},
                                                     {Start::Stretched, "stretched 5x"},
                                                     {Start::Scrambled, "scrambled"},
                                                     {Start::Mirrored, "mirrored"},
                                                     {Start::Noise, "noise"}};

State violentState(const World& world, Start start) {
    State state = world.initialState();
    // One random number per lattice point, or the copies would be torn apart before the first step.
    const auto draw = [&](int node) {
        const Vec3 x = 1000 * world.restPosition(node);
        Random random(static_cast<std::uint64_t>(x[0] + 5000) * 1000003u +
                      static_cast<std::uint64_t>(x[1] + 5000) * 1009u +
                      static_cast<std::uint64_t>(x[2] + 5000));
        return random.vector();
    };
    for (int node = 0; node < world.nodeCount(); ++node) {
        const Vec3 x = world.restPosition(node);
        Vec3 &u = state.displacement[node], &v = state.velocity[node];
        switch (start) {
            case Start::Impact:
                if (x.norm() < 0.16) v = {0, 0, -200};
                break;
            case Start::Stretched:
                u = 4 * x;
                break;
            case Start::Scrambled:
                u = 0.3 * draw(node) - x;
                break;
            case Start::Mirrored:
                u[0] = -2 * x[0];
                break;
            case Start::Noise:
                v = 200 * draw(node);
                break;
        }
        for (int i = 0; i < 3; ++i) {
            u[i] = static_cast<float>(u[i]);
            v[i] = static_cast<float>(v[i]);
        }
    }
    return state;
}

int invertedTetrahedra(const World& world, const State& state) {
    int inverted = 0;
    for (int cell = 0; cell < world.cellCount(); ++cell)
        for (const Mat3& F : cellGradients(world, cell, state.displacement, 1))
            inverted += F.determinant() <= 0;
    return inverted;
}

struct Case {
    ConstitutiveLaw law;
    std::pair<Start, const char*> start;
    double youngModulus, poissonRatio, framesPerSecond;
};

struct Outcome {
    bool limited = false;
    std::int64_t nan = 0;
    int inverted = 0;
    double energyBefore = 0, energyAfter = 0, highestEnergy = 0;  ///< J
};

double energy(const Diagnostics& d) {
    return d.kinetic + d.elastic;
}

Outcome run(const Case& c) {
    Material material = softElastic();
    material.youngModulus = c.youngModulus;
    material.poissonRatio = c.poissonRatio;
    material.law = c.law;
    WorldDescription description = block({3, 3, 2}, material);
    description.step = 1 / (c.framesPerSecond * 50);
    const World world(description);
    cpu::CpuSolver solver(world, 1);
    State state = violentState(world, c.start.first);
    solver.setState(state);
    Outcome result;
    result.limited = world.laws()[0].limited;
    result.energyBefore = energy(diagnose(world, state));
    const int checks = 60, steps = static_cast<int>(6 / world.step() + 0.5);
    for (int check = 0; check < checks; ++check) {
        solver.advance(steps / checks);
        state = solver.state();
        const Diagnostics now = diagnose(world, state);
        result.nan = std::max(result.nan, now.nan);
        result.energyAfter = energy(now);
        result.highestEnergy = std::max(result.highestEnergy, result.energyAfter);
    }
    result.inverted = invertedTetrahedra(world, state);
    return result;
}

/// Every case on its own, on all cores.
std::vector<Outcome> runAll(const std::vector<Case>& cases) {
    std::vector<Outcome> outcomes(cases.size());
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back([&] {
            for (std::size_t k; (k = next++) < cases.size();) outcomes[k] = run(cases[k]);
        });
    for (std::thread& thread : threads) thread.join();
    return outcomes;
}

}  // namespace

TEST_CASE("whatever the start, a wall never explodes", "[long]") {
    constexpr double youngModuli[] = {1e3, 1e5, 1e7, 1e10}, poissonRatios[] = {0, 0.3, 0.45},
                     framesPerSecond[] = {120, 60, 30, 15};
    std::vector<Case> cases;
    for (const ConstitutiveLaw law : {ConstitutiveLaw::Corotated, ConstitutiveLaw::Green})
        for (const auto& start : kStarts)
            for (const double E : youngModuli)
                for (const double nu : poissonRatios)
                    for (const double fps : framesPerSecond)
                        cases.push_back({law, start, E, nu, fps});
    const std::vector<Outcome> outcomes = runAll(cases);

    std::ostringstream map;
    map << "90 tetrahedra, 6 s in frames of 1/120, 1/60, 1/30, 1/15 s for each Poisson's ratio\n"
           "ok: nothing inverted at the end; a number: tetrahedra inverted; ~: stiffness limited\n"
           "                         E   nu = 0               nu = 0.3             nu = 0.45\n";
    int corotated = 0;
    const std::size_t perRow = std::size(poissonRatios) * std::size(framesPerSecond);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& c = cases[i];
        const Outcome& o = outcomes[i];
        if (i % perRow == 0)
            map << '\n'
                << std::left << std::setw(10) << toString(c.law) << std::setw(13) << c.start.second
                << std::right << std::setw(6) << c.youngModulus;
        if (i % std::size(framesPerSecond) == 0) map << ' ';
        map << std::setw(3) << (o.limited ? '~' : ' ') << std::left << std::setw(2)
            << (o.nan        ? "NaN"
                : o.inverted ? std::to_string(o.inverted)
                             : "ok")
            << std::right;

        INFO(toString(c.law) << ", " << c.start.second << ", E " << c.youngModulus << ", nu "
                             << c.poissonRatio << ", fps " << c.framesPerSecond);
        CHECK(o.nan == 0);
        if (c.law != ConstitutiveLaw::Corotated) continue;
        ++corotated;
        CHECK(o.energyAfter <= o.energyBefore);
        CHECK(o.highestEnergy <= o.energyBefore);
        CHECK(o.inverted == 0);
    }
    std::cout << map.str() << "\n\n";
    CHECK(corotated >= 200);
}
