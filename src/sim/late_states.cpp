#include "sim/late_states.hpp"

namespace sunder::sim {

void LateStates::setSolver(const core::Solver& solver, bool waits) {
    *this = {};
    solver_ = &solver;
    waits_ = waits;
}

void LateStates::forget() {
    for (Copy& copy : copies_) copy.frame = -1;
    seenFrame_ = -1;
}

void LateStates::advanced() {
    ++frame_;
    finished_ = false;
    if (!waits_ || frame_ - looked_ > kPatience) return;
    Copy& copy = copyOf(frame_);
    if (!copy.state) copy.state = solver_->makeStateCopy();
    copy.state->start();
    copy.frame = frame_;
}

const core::State& LateStates::look() {
    looked_ = frame_;
    const std::int64_t wanted = frame_ - kLateness;
    if (seenFrame_ >= wanted && seenFrame_ >= 0) return seen_;
    if (wanted >= 0 && copyOf(wanted).frame == wanted) {
        seen_ = copyOf(wanted).state->take();
        seenFrame_ = wanted;
    } else {
        seen_ = solver_->state();
        seenFrame_ = frame_;
    }
    return seen_;
}

}  // namespace sunder::sim
