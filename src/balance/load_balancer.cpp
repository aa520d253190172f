#include "balance/load_balancer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace sunder::balance {
namespace {

/// A trial ends when so many frames in a row were no faster than the fastest: before, bodies have
/// just moved, a driver compiles what it has not run yet, the clocks of a GPU that idled go up.
constexpr int kSteadyFrames = 4;
constexpr double kFaster = 0.97;
constexpr int kLongestTrial = 60;
/// A trial this much slower than the best one is given up.
constexpr double kHopeless = 2;
constexpr int kFramesBeforeGivingUp = 3;
/// From a share to its neighbours.
constexpr double kNeighbour = 0.15;
/// The load has changed when this much of it was added or fell asleep.
constexpr double kLoadChange = 0.25;
/// Speeds drift (clocks, other programs): look again after so many frames.
constexpr int kSettledFrames = 1200;

}  // namespace

LoadBalancer::LoadBalancer(std::vector<int> cells)
    : cells_(std::move(cells)), largestFirst_(cells_.size()), onGpu_(cells_.size(), false) {
    std::iota(largestFirst_.begin(), largestFirst_.end(), 0);
    std::stable_sort(largestFirst_.begin(), largestFirst_.end(),
                     [&](std::size_t a, std::size_t b) { return cells_[a] > cells_[b]; });
}

bool LoadBalancer::frame(const std::vector<bool>& awake) {
    std::int64_t load = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) load += awake[i] ? cells_[i] : 0;
    if (load == 0) return false;
    const double ratio =
        static_cast<double>(load) / static_cast<double>(std::max<std::int64_t>(load_, 1));
    if (ratio > 2 || ratio < 0.5) {
        load_ = load;
        fromScratch_ = true;
        begin({0, 1});
    } else if (!trying_ && (std::abs(ratio - 1) > kLoadChange || frames_ >= kSettledFrames)) {
        load_ = load;
        fromScratch_ = false;
        begin({share_});
    }
    place(awake);
    ++frames_;
    return trying_;
}

void LoadBalancer::begin(std::vector<double> shares) {
    tried_.clear();
    untried_ = std::move(shares);
    nextTrial();
}

void LoadBalancer::nextTrial() {
    trying_ = !untried_.empty();
    frames_ = lastGain_ = 0;
    fastest_ = std::numeric_limits<double>::infinity();
    if (trying_) {
        share_ = untried_.back();
        untried_.pop_back();
    } else {
        share_ = best().share;
    }
}

const LoadBalancer::Trial& LoadBalancer::best() const {
    return *std::min_element(tried_.begin(), tried_.end(),
                             [](const Trial& a, const Trial& b) { return a.time < b.time; });
}

void LoadBalancer::measured(double time) {
    if (!trying_) return;
    if (time < kFaster * fastest_) lastGain_ = frames_;
    fastest_ = std::min(fastest_, time);
    const bool hopeless =
        frames_ >= kFramesBeforeGivingUp && !tried_.empty() && fastest_ > kHopeless * best().time;
    if (frames_ - lastGain_ < kSteadyFrames && frames_ < kLongestTrial && !hopeless) return;
    tried_.push_back({share_, fastest_});
    if (untried_.empty()) addTrials();
    nextTrial();
}

void LoadBalancer::addTrials() {
    if (fromScratch_ && tried_.size() == 2) {
        // Both sides done together: share·gpu = (1 − share)·cpu.
        const double gpu = tried_[0].time, cpu = tried_[1].time;
        untried_ = {cpu / (cpu + gpu)};
        return;
    }
    for (const double step : {-kNeighbour, kNeighbour}) {
        const double share = std::clamp(best().share + step, 0.0, 1.0);
        const bool known = std::any_of(tried_.begin(), tried_.end(), [&](const Trial& trial) {
            return std::abs(trial.share - share) < 0.5 * kNeighbour;
        });
        if (!known) untried_.push_back(share);
    }
}

/// Moves as few bodies as it takes to come close to the share.
void LoadBalancer::place(const std::vector<bool>& awake) {
    std::int64_t total = 0, gpu = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        if (!awake[i]) continue;
        total += cells_[i];
        gpu += onGpu_[i] ? cells_[i] : 0;
    }
    auto missing = static_cast<double>(total) * share_ - static_cast<double>(gpu);
    // A body moves where that brings the share closer, larger ones first.
    for (const std::size_t i : largestFirst_) {
        if (!awake[i] || onGpu_[i] == (missing > 0)) continue;
        if (std::abs(missing) < 0.5 * cells_[i]) continue;
        missing += onGpu_[i] ? cells_[i] : -cells_[i];
        onGpu_[i] = !onGpu_[i];
    }
}

}  // namespace sunder::balance
