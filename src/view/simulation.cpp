#include "view/simulation.hpp"

#include "core/body_host.hpp"
#include "gpu/pass_timer.hpp"

namespace sunder::view {

using namespace core;

namespace {

WorldDescription played(WorldDescription world, bool hits) {
    if (!hits) world.events.clear();
    return world;
}

}  // namespace

void apply(const Push& push, const World& world, State& state, std::set<int>& bodies) {
    if (push.object >= 0) {
        if (world.objects()[push.object].inverseMass > 0)
            state.objects[push.object].velocity += push.velocity;
        return;
    }
    const double reach = push.radius * push.radius;
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (!world.present(cell)) continue;
        for (int node = kCorners * cell; node < kCorners * (cell + 1); ++node) {
            if (world.anchored(node)) continue;
            const Vec3 place = world.restPosition(node) + state.displacement[node];
            const double away = (place - push.place).squaredNorm();
            // Joined copies of a node are at the same place to the bit, so they stay together.
            if (away >= reach) continue;
            state.velocity[node] += (1 - away / reach) * push.velocity;
            bodies.insert(world.bodyOf(cell));
        }
    }
}

Simulation::Simulation(scene::Scene scene, const std::string& solver, bool hits, const State* state)
    : scene_(std::move(scene)), world_(played(scene_.world, hits)), buffers_(world_) {
    const sim::SolverInfo& info = sim::findSolver(solver);
    auto made = sim::makeSolver(info, world_, &buffers_);
    made->setState(state ? *state : start().state);
    atStart_ = !state;
    stepsDone_ = state ? state->step : 0;
    adopt(std::move(made), info);
}

void Simulation::adopt(std::unique_ptr<Solver> solver, const sim::SolverInfo& info) {
    auto view = std::make_unique<sim::SolverView>(world_, *solver);
    solver->setIncidents(&incidents_);
    view_ = std::move(view);
    solver_ = std::move(solver);
    info_ = &info;
    state_.reset();
}

void Simulation::setSolver(const std::string& name) {
    const sim::SolverInfo& info = sim::findSolver(name);
    auto next = sim::makeSolver(info, world_, &buffers_);
    next->setState(state());
    adopt(std::move(next), info);
}

void Simulation::restart() {
    solver_->setState(start().state);
    stepsDone_ = 0;
    atStart_ = true;
    state_.reset();
}

const cpu::Start& Simulation::start() {
    if (!start_) start_ = cpu::settledStart(world_);
    return *start_;
}

void Simulation::advance(const std::vector<Push>& pushes, int steps) {
    atStart_ &= pushes.empty() && steps < 1;
    if (!pushes.empty()) {
        State pushed = state();
        std::set<int> bodies;
        for (const Push& push : pushes) apply(push, world_, pushed, bodies);
        if (auto* host = dynamic_cast<BodyHost*>(solver_.get()))
            host->adopt({bodies.begin(), bodies.end()}, pushed);
        else
            solver_->setState(pushed);
        state_.reset();
    }
    if (steps < 1) return;
    solver_->advance(steps);
    solver_->finish();
    stepsDone_ += steps;
    state_.reset();
}

const State& Simulation::state() {
    if (!state_) state_ = solver_->state();
    return *state_;
}

void Simulation::timePasses(gpu::PassTimer* timer) {
    if (auto* onGpu = dynamic_cast<gpu::GpuSolver*>(solver_.get())) onGpu->setPassTimer(timer);
}

}  // namespace sunder::view
