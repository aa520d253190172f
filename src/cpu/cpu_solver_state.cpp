// What CpuSolver knows: states, saved states, bodies that come from another solver.
#include "core/archive.hpp"
#include "cpu/cpu_runner.hpp"
#include "cpu/cpu_solver.hpp"

namespace sunder::cpu {

using namespace core;

State CpuSolver::state() const {
    State state = world_.initialState();
    state.step = step_;
    state.pushes = events_.added(step_);
    book_.describe(state);
    for (const int body : book_.activeBodies()) bodies_[body]->store(state);
    storeObjects(state);
    return state;
}

void CpuSolver::setState(const State& state) {
    step_ = state.step;
    events_.setAdded(state.pushes);
    book_.follow(state);
    shareOut();
    for (int body = 0; body < bodyCount(); ++body) {
        bodies_[body]->setAddedPatches(state.pushes, step_);
        bodies_[body]->setReleased(book_.released(body));
        if (holds(body)) bodies_[body]->load(state);
    }
    book_.wakeAll();
    if (runner_->objects) runner_->objects->set(state.objects);
    if (runner_->watch) runner_->watch->forget();
}

void CpuSolver::archive(Archive& a) {
    a.section("step");
    const std::int64_t step = a.step(step_);
    events_.archive(a, step);
    const std::vector<bool> active = book_.archiveBodies(a);
    if (a.reads()) {
        shareOut();
        for (int body = 0; body < bodyCount(); ++body)
            bodies_[body]->setReleased(book_.released(body));
    }
    Runner& runner = *runner_;
    a.section("looks");
    const bool watched = a.flag(runner.watch != nullptr);
    for (const auto& run : bodies_) run->archive(a, watched);
    IncidentWatch::archive(a, world_, runner.watch.get());
    if (a.reads()) {
        step_ = step;
        for (const auto& run : bodies_) run->setAddedPatches(events_.added(step), step);
    }
    if (runner.contact) archiveTouching(a, active);
}

void CpuSolver::archiveTouching(Archive& a, const std::vector<bool>& active) {
    Runner& runner = *runner_;
    book_.archiveSleepers(a, active);
    for (int body = 0; body < bodyCount(); ++body) {
        BodyRun& run = *bodies_[body];
        if (!a.reads() || run.asleep() == book_.asleep(body)) continue;
        if (run.asleep())
            run.wake();
        else
            run.fallAsleep();
    }
    runner.team.run([&] {
        runner.contact->archive(a, active, [&](int count, const std::function<void(int)>& work) {
            runner.team.forEach(count, work);
        });
    });
    if (runner.objects) runner.objects->archive(a);
    if (!a.reads()) return;
    for (int object = 0; object < objectCount(); ++object)
        if (book_.objectAsleep(object)) runner.objects->fallAsleep(object);
    for (int body = 0; body < bodyCount(); ++body) {
        runner.touching[body] =
            runner.contact->touching(body) || (runner.objects && runner.objects->near(body));
        bodies_[body]->setTouching(runner.touching[body]);
    }
    findIslands();
}

void CpuSolver::adopt(const std::vector<int>& bodies, const State& state) {
    for (const int body : bodies) {
        wake(memberOfBody(body));
        if (present(body)) bodies_[body]->load(state);
        book_.setHeld(body, true);
    }
    setObjects(state);
    shareOut();
}

void CpuSolver::release(const std::vector<int>& bodies, State& state) {
    for (const int body : bodies) {
        wake(memberOfBody(body));
        bodies_[body]->store(state);
        book_.setHeld(body, false);
    }
    storeObjects(state);
    shareOut();
}

/// Those that are as they were sleep on.
void CpuSolver::setObjects(const State& state) {
    if (!runner_->objects) return;
    Objects& objects = *runner_->objects;
    for (int object = 0; object < static_cast<int>(state.objects.size()); ++object) {
        if (objects.states()[object] == state.objects[object]) continue;
        putObject(object, state.objects[object]);
    }
}

void CpuSolver::store(int body, State& state) const {
    bodies_[body]->store(state);
}

void CpuSolver::storeObjects(State& state) const {
    if (runner_->objects) state.objects = runner_->objects->states();
}

}  // namespace sunder::cpu
