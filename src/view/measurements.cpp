#include "view/measurements.hpp"

#include <algorithm>
#include <numeric>

namespace sunder::view {

void History::add(double value) {
    values_[next_] = static_cast<float>(value);
    next_ = (next_ + 1) % kLength;
    filled_ = std::min(filled_ + 1, kLength);
}

double History::mean(int count) const {
    count = std::min(count, filled_);
    double sum = 0;
    for (int i = 1; i <= count; ++i) sum += values_[(next_ - i + kLength) % kLength];
    return count > 0 ? sum / count : 0;
}

double History::largest() const {
    return *std::max_element(values_.begin(), values_.end());
}

double Measurements::framesPerSecond() const {
    const double mean = frame.mean(30);
    return mean > 0 ? 1000 / mean : 0;
}

void Measurements::addPasses(const std::vector<gpu::PassTimer::Times>& times) {
    for (const gpu::PassTimer::Times& pass : times) {
        auto known = std::find_if(passes.begin(), passes.end(),
                                  [&](const auto& entry) { return entry.first == pass.pass; });
        // A timer goes on naming the passes of a solver that is no longer there.
        if (known == passes.end() && pass.milliseconds.empty()) continue;
        if (known == passes.end()) known = passes.insert(known, {pass.pass, History()});
        known->second.add(std::accumulate(pass.milliseconds.begin(), pass.milliseconds.end(), 0.));
    }
}

}  // namespace sunder::view
