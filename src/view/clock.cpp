#include "view/clock.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::view {

void Clock::setStep(double step) {
    step_ = step;
    owed_ = most_ = 0;
}

void Clock::setSpeed(double speed) {
    speed_ = std::clamp(speed, kSlowest, 1.0);
    recent_.clear();
}

void Clock::setFixed(bool fixed) {
    fixed_ = fixed;
    owed_ = 0;
}

int Clock::tick(double elapsed) {
    if (std::exchange(skip_, false)) elapsed = std::min(elapsed, 1.0 / 60);
    if (paused_) {
        owed_ = 0;
        recent_.clear();
        return std::exchange(once_, 0);
    }
    once_ = 0;
    if (fixed_) {
        owed_ += speed_ / 60;
        const double due = std::floor(owed_ / step_ + 1e-6);  // see below
        owed_ = std::max(0.0, owed_ - due * step_);
        return static_cast<int>(due);
    }

    const double wanted = std::max(elapsed, 0.0) * speed_;
    // Half of a frame for simulating: the next frame is at most twice as long as the rest of it,
    // however long this one was.
    budget_ = std::clamp(elapsed / 2, kMostWork, kMostTime);
    owed_ += wanted;
    // Without the small share, 50 steps of 1/3000 s would be a hair more than 1/60 s.
    const double due = std::floor(owed_ / step_ + 1e-6);
    double most = std::max(1.0, std::floor(kMostTime / step_ + 1e-6));
    if (most_ > 0) most = std::min(most, std::floor(most_));
    const int steps = static_cast<int>(std::min(due, most));
    owed_ = std::max(0.0, owed_ - steps * step_);
    if (steps < due) {
        const double rest = std::fmod(owed_, step_);
        dropped_ += owed_ - rest;
        owed_ = rest;
    }
    recent_.push_back({elapsed, wanted, steps * step_});
    double total = 0;
    for (const Frame& frame : recent_) total += frame.elapsed;
    while (recent_.size() > 1 && total - recent_.front().elapsed > 1) {
        total -= recent_.front().elapsed;
        recent_.pop_front();
    }
    return steps;
}

void Clock::took(int steps, double seconds) {
    if (steps < 1) return;
    // What a step costs is not known by looking at one: the first compiles, some wake a heap.
    if (seconds > budget_)
        most_ = std::max(1.0, steps * budget_ / seconds);
    else if (most_ > 0)
        most_ = std::min(1.5 * most_ + 1, 1e9);
}

double Clock::share() const {
    double wanted = 0, simulated = 0;
    for (const Frame& frame : recent_) {
        wanted += frame.wanted;
        simulated += frame.simulated;
    }
    // A step or two may still be owed.
    return wanted > 4 * step_ ? std::min(1.0, (simulated + 2 * step_) / wanted) : 1;
}

}  // namespace sunder::view
