#include "sim/simulation.hpp"

#include <algorithm>
#include <utility>

#include "core/contact.hpp"
#include "core/sleep.hpp"

namespace sunder::sim {

using namespace core;

Simulation::Simulation(std::shared_ptr<const Layout> layout, const SolverInfo& info,
                       const cpu::Threads& threads, std::size_t incidents)
    : layout_(std::move(layout)),
      threads_(threads),
      findsIncidents_(incidents > 0),
      incidents_(std::max<std::size_t>(incidents, 1)) {
    adopt(info.make(*layout_, threads_), info);
    touchAll();
}

void Simulation::adopt(MadeSolver made, const SolverInfo& info) {
    if (findsIncidents_) made.solver->setIncidents(&incidents_);
    made_ = std::move(made);
    late_.setSolver(*made_.solver, made_.onGpu != nullptr);
    info_ = &info;
    state_.reset();
}

void Simulation::setSolver(const SolverInfo& info) {
    MadeSolver next = info.make(*layout_, threads_);
    next.solver->setState(state());
    adopt(std::move(next), info);
    touchAll();
}

void Simulation::extend(std::shared_ptr<const Layout> layout) {
    finish();
    State larger = layout->world().initialState();
    const State& now = state();
    const auto first = [](const auto& from, auto& to) {
        std::copy(from.begin(), from.end(), to.begin());
    };
    first(now.displacement, larger.displacement);
    first(now.velocity, larger.velocity);
    first(now.damage, larger.damage);
    first(now.slow, larger.slow);
    first(now.slowStress, larger.slowStress);
    first(now.objects, larger.objects);
    larger.step = now.step;
    larger.pushes = now.pushes;
    larger.released = now.released;
    const auto bodies = static_cast<int>(world().bodies().size());
    std::erase_if(larger.absent, [&](int body) { return body < bodies; });
    larger.absent.insert(larger.absent.begin(), now.absent.begin(), now.absent.end());
    MadeSolver made = info_->make(*layout, threads_);
    made.solver->setState(larger);
    adopt(std::move(made), *info_);
    layout_ = std::move(layout);
    start_.reset();
    touchAll();
}

const cpu::Start& Simulation::start(const cpu::SettleProgress& progress) {
    if (!start_) start_ = cpu::settledStart(world(), progress, threads_);
    return *start_;
}

void Simulation::restart() {
    setState(start().state);
}

void Simulation::setState(const State& state) {
    made_.solver->setState(state);
    step_ = state.step;
    changes_.clear();
    state_.reset();
    late_.forget();
    touchAll();
}

std::vector<std::byte> Simulation::saveState() {
    return core::saveState(world(), *made_.solver, changes_);
}

void Simulation::restoreState(std::span<const std::byte> bytes) {
    step_ = core::restoreState(world(), *made_.solver, bytes, changes_);
    state_.reset();
    late_.forget();
    touchAll();
}

const State& Simulation::state() {
    if (!state_) state_ = made_.solver->state();
    return *state_;
}

const State& Simulation::lateState() {
    return late_.present() ? state() : late_.look();
}

void Simulation::finish() {
    made_.solver->finish();
    late_.finished();
}

void Simulation::push(const EventDescription& event) {
    EventDescription pushed = event;
    // What is not there yet is pushed once it is.
    if (comes(event.body))
        pushed.time += static_cast<double>(nextSearch() - step_) * world().step();
    const bool released = event.body >= 0 &&
                          event.body < static_cast<int>(world().bodies().size()) &&
                          this->released(event.body);
    made_.solver->push(world().makeEvent(pushed, time(), released));
    state_.reset();
}

void Simulation::throwObject(const ThrowDescription& thrown) {
    putObject(thrown.object, world().makeThrow(thrown));
}

void Simulation::putObject(int object, const ObjectState& state) {
    made_.solver->putObject(object, state);
    ++version_;
    state_.reset();
}

void Simulation::checkBody(int body) const {
    const auto count = static_cast<int>(world().bodies().size());
    if (body >= 0 && body < count) return;
    throw InputError("there is no body " + std::to_string(body) + "; the world has " +
                     std::to_string(count));
}

bool Simulation::released(int body) const {
    const PresenceChange* last = lastChange(body);
    return last ? last->released : made_.solver->released(body);
}

void Simulation::releaseAnchors(int body) {
    checkBody(body);
    const auto own = std::find_if(
        changes_.begin(), changes_.end(),
        [&](const PresenceChange& change) { return change.body == body && change.present; });
    if (own != changes_.end())
        own->released = true;
    else
        made_.solver->releaseAnchors(body);
    state_.reset();
}

void Simulation::setPresent(int body, bool present) {
    checkBody(body);
    if (present == this->present(body)) return;
    state_.reset();
    if (nextSearch() == step_) {
        late_.forget();
        touch(body);
        return made_.solver->setPresent(body, present);
    }
    // What was to come does not, and nothing else is left to do if it was not there before.
    if (!present && comes(body))
        std::erase_if(changes_, [&](const PresenceChange& change) {
            return change.body == body && change.present;
        });
    else
        changes_.push_back({body, present});
}

const PresenceChange* Simulation::lastChange(int body) const {
    const auto last =
        std::find_if(changes_.rbegin(), changes_.rend(),
                     [&](const PresenceChange& change) { return change.body == body; });
    return last == changes_.rend() ? nullptr : &*last;
}

bool Simulation::comes(int body) const {
    const PresenceChange* last = lastChange(body);
    return last && last->present;
}

bool Simulation::present(int body) const {
    const PresenceChange* last = lastChange(body);
    return last ? last->present : made_.solver->present(body);
}

std::int64_t Simulation::nextSearch() const {
    const int interval = world().contactInterval();
    return (step_ + interval - 1) / interval * interval;
}

bool Simulation::rests(int body) const {
    return !made_.solver->present(body) || made_.solver->asleep(body);
}

void Simulation::touchAll() {
    versions_.assign(world().bodies().size(), ++version_);
}

bool Simulation::atRest() const {
    if (!changes_.empty()) return false;
    for (int body = 0; body < static_cast<int>(world().bodies().size()); ++body)
        if (!rests(body)) return false;
    for (int object = 0; object < static_cast<int>(world().objects().size()); ++object)
        if (!world().description().objects[object].fixed && !made_.solver->objectAsleep(object))
            return false;
    return true;
}

void Simulation::advance(int steps) {
    if (steps < 1) return;
    if (!changes_.empty() && step_ + steps >= nextSearch()) {
        const auto first = static_cast<int>(nextSearch() - step_);
        advanceSolver(first);
        steps -= first;
        for (const PresenceChange& change : changes_) {
            made_.solver->setPresent(change.body, change.present);
            if (change.released) made_.solver->releaseAnchors(change.body);
            touch(change.body);
        }
        changes_.clear();
        state_.reset();
        late_.forget();
    }
    advanceSolver(steps);
    late_.advanced();
}

void Simulation::advanceSolver(int steps) {
    if (steps < 1) return;
    const auto bodies = static_cast<int>(versions_.size());
    std::vector<bool> rested;
    for (int body = 0; body < bodies; ++body) rested.push_back(rests(body));
    if (!atRest()) ++version_;
    made_.solver->advance(steps);
    step_ += steps;
    state_.reset();
    // What wakes in between is still awake in the end: it takes as long to fall asleep again.
    const bool brief = steps < sleepSteps(world());
    for (int body = 0; body < bodies; ++body)
        if (!(brief && rested[body] && rests(body))) touch(body);
}

}  // namespace sunder::sim
