#include "balance/balanced_solver.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "core/archive.hpp"

namespace sunder::balance {

using namespace core;

namespace {

/// What moves as one. Bodies that may touch each other are advanced by one solver.
std::vector<int> cellCounts(const World& world) {
    if (world.description().contact) return {world.cellCount()};
    std::vector<int> counts;
    for (const Body& body : world.bodies()) counts.push_back(body.cellCount());
    return counts;
}

}  // namespace

BalancedSolver::BalancedSolver(const World& world, const gpu::WorldBuffers& buffers,
                               const cpu::Threads& threads)
    : world_(world),
      gather_(world, buffers),
      cpu_(world, threads),
      balancer_(cellCounts(world)),
      scratch_(world.initialState()) {
    std::vector<int> all(world.bodies().size());
    std::iota(all.begin(), all.end(), 0);
    gather_.release(all, scratch_);
}

void BalancedSolver::advance(int steps) {
    std::vector<bool> awake;
    for (int body = 0; body < static_cast<int>(world_.bodies().size()); ++body)
        awake.push_back(present(body) && !asleep(body));
    if (world_.description().contact)
        awake = {!world_.objects().empty() || std::count(awake.begin(), awake.end(), true) > 0};
    const bool measure = balancer_.frame(awake);
    moveBodies();
    if (measure) finish();
    const auto start = std::chrono::steady_clock::now();
    gather_.advance(steps);
    cpu_.advance(steps);
    scratch_.step += steps;
    if (!measure) return;
    finish();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    balancer_.measured(elapsed.count() / steps);
}

void BalancedSolver::moveBodies() {
    std::vector<int> toGpu, toCpu;
    for (int body = 0; body < static_cast<int>(world_.bodies().size()); ++body)
        if (wantedOnGpu(body) != onGpu(body)) (onGpu(body) ? toCpu : toGpu).push_back(body);
    if (!toCpu.empty()) {
        gather_.release(toCpu, scratch_);
        cpu_.adopt(toCpu, scratch_);
    }
    if (!toGpu.empty()) {
        cpu_.release(toGpu, scratch_);
        gather_.adopt(toGpu, scratch_);
    }
}

bool BalancedSolver::wantedOnGpu(int body) const {
    return balancer_.onGpu(world_.description().contact ? 0 : body);
}

std::optional<int> BalancedSolver::bodiesOnGpu() const {
    int count = 0;
    for (int body = 0; body < static_cast<int>(world_.bodies().size()); ++body)
        count += onGpu(body);
    return count;
}

State BalancedSolver::state() const {
    State state = gather_.state();
    addCpu(state);
    return state;
}

void BalancedSolver::addCpu(State& state) const {
    for (int body = 0; body < static_cast<int>(world_.bodies().size()); ++body)
        if (!onGpu(body) && present(body)) cpu_.store(body, state);
    if (!onGpu(0)) cpu_.storeObjects(state);
}

/// What the CPU has is at hand at once; only where the GPU has anything, it is copied, too.
class BalancedSolver::LateState : public StateCopy {
  public:
    explicit LateState(const BalancedSolver& solver)
        : solver_(solver), gpu_(solver.gather_.makeStateCopy()) {}
    void start() override {
        now_ = solver_.world_.initialState();
        solver_.addCpu(now_);
        onCpu_.clear();
        for (int body = 0; body < static_cast<int>(solver_.world_.bodies().size()); ++body)
            if (!solver_.onGpu(body)) onCpu_.push_back(body);
        gpu_->start();
    }
    State take() override {
        State state = gpu_->take();
        for (const int body : onCpu_) solver_.world_.copyBody(now_, body, state);
        if (!onCpu_.empty() && onCpu_.front() == 0) state.objects = now_.objects;
        return state;
    }

  private:
    const BalancedSolver& solver_;
    std::unique_ptr<StateCopy> gpu_;
    State now_;  ///< where the CPU has it
    std::vector<int> onCpu_;
};

std::unique_ptr<StateCopy> BalancedSolver::makeStateCopy() const {
    return std::make_unique<LateState>(*this);
}

void BalancedSolver::setState(const State& state) {
    gather_.setState(state);
    cpu_.setState(state);
    scratch_.step = state.step;
}

void BalancedSolver::archive(Archive& a) {
    a.section("step");
    State now = a.writes() ? state() : world_.initialState();
    now.step = a.step(now.step);
    a.section("pushes");
    a.list(now.pushes, kMaxPushes, [&](Event& event) { core::archive(a, world_, event); });
    archiveBodies(a, world_, now.absent, now.released);
    archiveCells<float>(a, world_, now);
    a.section("objects");
    for (ObjectState& object : now.objects) core::archive(a, object);
    if (a.reads()) setState(now);
}

bool BalancedSolver::asleep(int body) const {
    return onGpu(body) ? gather_.asleep(body) : cpu_.asleep(body);
}

bool BalancedSolver::objectAsleep(int object) const {
    return onGpu(0) ? gather_.objectAsleep(object) : cpu_.objectAsleep(object);
}

gpu::StateView BalancedSolver::view() {
    for (int body = 0; body < static_cast<int>(world_.bodies().size()); ++body) {
        if (onGpu(body) || !present(body)) continue;
        cpu_.store(body, scratch_);
        gather_.show(body, scratch_);
    }
    if (!onGpu(0)) {
        cpu_.storeObjects(scratch_);
        gather_.showObjects(scratch_);
    }
    return gather_.view();
}

}  // namespace sunder::balance
