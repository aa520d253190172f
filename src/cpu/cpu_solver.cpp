#include "cpu/cpu_solver.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>

#include "cpu/cpu_body_run.hpp"
#include "cpu/flush_denormals.hpp"

namespace sunder {
namespace {

/// A stretch of fewer vectors is not worth a thread of its own.
constexpr int kVectorsPerPart = 16;

}  // namespace

struct CpuSolver::BodyRun : cpu::BodyRun {
    using cpu::BodyRun::BodyRun;
    bool held = true;
};

/// The threads, and how bodies are shared out to them.
struct CpuSolver::Runner {
    std::vector<cpu::Law> laws;
    int threads = 1;
    /// oneTBB hands out no more threads than the machine has cores unless told to.
    std::optional<tbb::global_control> more;
    std::optional<tbb::task_arena> arena;
    std::vector<cpu::BodyRun*> whole, split;  ///< one thread each; all threads on each in turn
};

CpuSolver::CpuSolver(const World& world, int threads)
    : world_(world), runner_(std::make_unique<Runner>()) {
    Runner& runner = *runner_;
    const int cores = tbb::this_task_arena::max_concurrency();
    runner.threads = threads > 0 ? threads : cores;
    if (runner.threads > 1) {
        if (runner.threads > cores)
            runner.more.emplace(tbb::global_control::max_allowed_parallelism,
                                static_cast<std::size_t>(runner.threads));
        runner.arena.emplace(runner.threads);
    }
    runner.laws = cpu::makeLaws(world);
    for (int body = 0; body < static_cast<int>(world.bodies().size()); ++body)
        bodies_.push_back(std::make_unique<BodyRun>(world, body, runner.laws));
    shareOut();
    setState(world.initialState());
}

void CpuSolver::shareOut() {
    Runner& runner = *runner_;
    runner.split.clear();
    runner.whole.clear();
    int cells = 0;
    for (const auto& run : bodies_) cells += run->held ? run->cells() : 0;
    // A body is split when one thread alone would still be at it after the others were done.
    const int fairShare = cells / (2 * runner.threads);
    for (const auto& run : bodies_) {
        if (!run->held) continue;
        const bool large = run->cells() > std::max(fairShare, 2 * kVectorsPerPart * cpu::kLanes);
        (runner.threads > 1 && large ? runner.split : runner.whole).push_back(run.get());
    }
}

CpuSolver::~CpuSolver() = default;

void CpuSolver::advance(int steps) {
    Runner& runner = *runner_;
    const auto alone = [&](cpu::BodyRun& run) {
        const cpu::FlushDenormals flush;
        run.advance(step_, steps, [](int vectors, const auto& work) { work(0, vectors, 0); });
    };
    const auto together = [&](cpu::BodyRun& run) {
        run.advance(step_, steps, [&](int vectors, const auto& work) {
            const int parts = std::min({cpu::BodyRun::kMaxParts, 4 * runner.threads,
                                        std::max(1, vectors / kVectorsPerPart)});
            tbb::parallel_for(
                tbb::blocked_range<int>(0, parts, 1),
                [&](const tbb::blocked_range<int>& range) {
                    const cpu::FlushDenormals flush;
                    for (int part = range.begin(); part < range.end(); ++part)
                        work(vectors * part / parts, vectors * (part + 1) / parts, part);
                },
                tbb::simple_partitioner());
        });
    };
    if (runner.threads == 1) {
        for (cpu::BodyRun* run : runner.whole) alone(*run);
    } else {
        runner.arena->execute([&] {
            for (cpu::BodyRun* run : runner.split) together(*run);
            tbb::parallel_for(std::size_t{0}, runner.whole.size(),
                              [&](std::size_t i) { alone(*runner.whole[i]); });
        });
    }
    step_ += steps;
}

State CpuSolver::state() const {
    State state = world_.initialState();
    state.step = step_;
    for (const auto& run : bodies_)
        if (run->held) run->store(state);
    return state;
}

void CpuSolver::setState(const State& state) {
    step_ = state.step;
    for (const auto& run : bodies_)
        if (run->held) run->load(state);
}

void CpuSolver::adopt(const std::vector<int>& bodies, const State& state) {
    for (const int body : bodies) {
        bodies_[body]->load(state);
        bodies_[body]->held = true;
    }
    shareOut();
}

void CpuSolver::release(const std::vector<int>& bodies, State& state) {
    for (const int body : bodies) {
        bodies_[body]->store(state);
        bodies_[body]->held = false;
    }
    shareOut();
}

bool CpuSolver::holds(int body) const {
    return bodies_[body]->held;
}

void CpuSolver::store(int body, State& state) const {
    bodies_[body]->store(state);
}

int CpuSolver::threads() const {
    return runner_->threads;
}
bool CpuSolver::asleep(int body) const {
    return bodies_[body]->held && bodies_[body]->asleep();
}

double CpuSolver::bytesPerTetrahedron() const {
    std::size_t bytes = 0;
    for (const auto& run : bodies_) bytes += run->bytes();
    return static_cast<double>(bytes) / (kTetrahedraPerCell * world_.presentCells());
}

}  // namespace sunder
