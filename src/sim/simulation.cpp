#include "sim/simulation.hpp"

#include <algorithm>
#include <utility>

#include "core/contact.hpp"

namespace sunder::sim {

using namespace core;

Simulation::Simulation(std::shared_ptr<const Layout> layout, const SolverInfo& info,
                       const cpu::Threads& threads, std::size_t incidents)
    : layout_(std::move(layout)),
      threads_(threads),
      findsIncidents_(incidents > 0),
      incidents_(std::max<std::size_t>(incidents, 1)) {
    adopt(info.make(*layout_, threads_), info);
}

void Simulation::adopt(MadeSolver made, const SolverInfo& info) {
    if (findsIncidents_) made.solver->setIncidents(&incidents_);
    made_ = std::move(made);
    info_ = &info;
    state_.reset();
}

void Simulation::setSolver(const SolverInfo& info) {
    MadeSolver next = info.make(*layout_, threads_);
    next.solver->setState(state());
    adopt(std::move(next), info);
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
}

std::vector<std::byte> Simulation::saveState() {
    return core::saveState(world(), *made_.solver, changes_);
}

void Simulation::restoreState(std::span<const std::byte> bytes) {
    step_ = core::restoreState(world(), *made_.solver, bytes, changes_);
    state_.reset();
}

const State& Simulation::state() {
    if (!state_) state_ = made_.solver->state();
    return *state_;
}

void Simulation::push(const EventDescription& event) {
    EventDescription pushed = event;
    // What is not there yet is pushed once it is.
    if (comes(event.body))
        pushed.time += static_cast<double>(nextSearch() - step_) * world().step();
    made_.solver->push(world().makeEvent(pushed, time()));
    state_.reset();
}

void Simulation::throwObject(const ThrowDescription& thrown) {
    putObject(thrown.object, world().makeThrow(thrown));
}

void Simulation::putObject(int object, const ObjectState& state) {
    made_.solver->putObject(object, state);
    state_.reset();
}

void Simulation::setPresent(int body, bool present) {
    const auto count = static_cast<int>(world().bodies().size());
    if (body < 0 || body >= count)
        throw InputError("there is no body " + std::to_string(body) + "; the world has " +
                         std::to_string(count));
    if (present == this->present(body)) return;
    state_.reset();
    if (nextSearch() == step_) return made_.solver->setPresent(body, present);
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
    return (step_ + kContactInterval - 1) / kContactInterval * kContactInterval;
}

bool Simulation::atRest() const {
    if (!changes_.empty()) return false;
    for (int body = 0; body < static_cast<int>(world().bodies().size()); ++body)
        if (made_.solver->present(body) && !made_.solver->asleep(body)) return false;
    for (int object = 0; object < static_cast<int>(world().objects().size()); ++object)
        if (!world().description().objects[object].fixed && !made_.solver->objectAsleep(object))
            return false;
    return true;
}

void Simulation::advance(int steps) {
    if (!changes_.empty() && step_ + steps >= nextSearch()) {
        const auto first = static_cast<int>(nextSearch() - step_);
        advanceSolver(first);
        steps -= first;
        for (const PresenceChange& change : changes_)
            made_.solver->setPresent(change.body, change.present);
        changes_.clear();
        state_.reset();
    }
    advanceSolver(steps);
}

void Simulation::advanceSolver(int steps) {
    if (steps < 1) return;
    made_.solver->advance(steps);
    step_ += steps;
    state_.reset();
}

}  // namespace sunder::sim
