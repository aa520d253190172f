// What LoadBalancer makes of machines whose times are known.
#include "balance/load_balancer.hpp"

#include <algorithm>
#include <functional>

#include "catch.hpp"

using sunder::balance::LoadBalancer;

namespace {

/// Time of a frame with so many cells on the CPU and on the GPU.
using Machine = std::function<double(double cpu, double gpu)>;

struct Run {
    LoadBalancer balancer;
    std::vector<int> cells;
    std::vector<bool> awake;
    int moves = 0, measured = 0;

    explicit Run(std::vector<int> bodies)
        : balancer(bodies), cells(bodies), awake(bodies.size(), true) {}

    /// Returns the time of the last frame.
    double frames(int count, const Machine& machine) {
        double time = 0;
        for (int i = 0; i < count; ++i) {
            std::vector<bool> before;
            for (std::size_t k = 0; k < cells.size(); ++k) before.push_back(balancer.onGpu(int(k)));
            const bool measure = balancer.frame(awake);
            double cpu = 0, gpu = 0;
            for (std::size_t k = 0; k < cells.size(); ++k) {
                moves += balancer.onGpu(int(k)) != before[k];
                if (awake[k]) (balancer.onGpu(int(k)) ? gpu : cpu) += cells[k];
            }
            time = machine(cpu, gpu);
            if (measure) balancer.measured(time);
            measured += measure;
        }
        return time;
    }
};

Machine bothAtOnce(double perCpuCell, double perGpuCell, double gpuOverhead) {
    return [=](double cpu, double gpu) {
        return std::max(perCpuCell * cpu, gpu > 0 ? gpuOverhead + perGpuCell * gpu : 0.0);
    };
}

const std::vector<int> kFifty(50, 80);

}  // namespace

TEST_CASE("bodies are shared out so that both sides are done together") {
    struct {
        double cpu, gpu, overhead;
    } const machines[] = {{1, 1, 0}, {1, 0.2, 0}, {1, 0.2, 400}, {1, 3, 0}, {1, 0.5, 1000}};
    for (const auto& m : machines) {
        INFO(m.cpu << ", " << m.gpu << ", " << m.overhead);
        const Machine machine = bothAtOnce(m.cpu, m.gpu, m.overhead);
        Run run(kFifty);
        const double time = run.frames(100, machine);
        double best = 1e30;
        for (int n = 0; n <= 50; ++n) best = std::min(best, machine(80. * (50 - n), 80. * n));
        // Neighbouring shares are 0.15 apart: the best may lie half of that away, and no more than
        // the whole of it.
        CHECK(time <= best + 0.15 * 4000 * std::max(m.cpu, m.gpu));
        CHECK(time <= machine(4000, 0));
        CHECK(time <= machine(0, 4000));
        CHECK(run.balancer.settled());
    }
}

TEST_CASE("a driver that computes on the CPU gets nothing") {
    Run run(kFifty);
    run.frames(100, [](double cpu, double gpu) { return cpu + 8 * gpu; });
    CHECK(run.balancer.share() == 0);
    for (int i = 0; i < 50; ++i) CHECK(!run.balancer.onGpu(i));
}

TEST_CASE("one body goes where it is fastest") {
    for (const double gpu : {0.5, 2.0}) {
        Run run({1000});
        run.frames(100, bothAtOnce(1, gpu, 0));
        CHECK(run.balancer.onGpu(0) == (gpu < 1));
    }
}

TEST_CASE("once settled, nothing is measured and nothing moves") {
    Run run(kFifty);
    run.frames(100, bothAtOnce(1, 0.3, 50));
    run.moves = run.measured = 0;
    run.frames(1000, bothAtOnce(1, 0.3, 50));
    CHECK(run.moves == 0);
    CHECK(run.measured == 0);
}

TEST_CASE("sleeping bodies stay where they are, and what is left is shared out anew") {
    Run run(kFifty);
    run.frames(100, bothAtOnce(1, 1, 0));
    std::vector<bool> where;
    for (int i = 0; i < 50; ++i) where.push_back(run.balancer.onGpu(i));
    // All that ran on the GPU falls asleep.
    for (int i = 0; i < 50; ++i) run.awake[i] = !where[i];
    run.frames(200, bothAtOnce(1, 1, 0));
    int moved = 0;
    for (int i = 0; i < 50; ++i) {
        if (!run.awake[i]) CHECK(run.balancer.onGpu(i));
        moved += run.balancer.onGpu(i) != where[i];
    }
    CHECK(moved > 5);
    CHECK(moved < 20);
    run.awake.assign(50, false);
    CHECK(!run.balancer.frame(run.awake));
}

TEST_CASE("a GPU that slows down loses bodies at the next look") {
    Run run(kFifty);
    run.frames(100, bothAtOnce(1, 0.1, 0));
    const double before = run.balancer.share();
    run.frames(2600, bothAtOnce(1, 2, 0));
    CHECK(before > 0.75);
    CHECK(run.balancer.share() < before - 0.25);
}
