#pragma once
#include <algorithm>
#include <chrono>

namespace sunder::view {

using Instant = std::chrono::steady_clock;

inline double seconds(Instant::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

inline double secondsSince(Instant::time_point start) {
    return seconds(Instant::now() - start);
}

/// Something to be done every so many seconds, and more seldom where it takes long.
class Every {
  public:
    /// `share`: of all time, that it may take at most; 1: whatever it takes.
    explicit Every(double period, double share = 1) : period_(period), share_(share) {}

    /// Does it when its time has come.
    template <class Work>
    void now(Work&& work) {
        const auto start = Instant::now();
        if (seconds(start - last_) < std::max(period_, cost_ / share_)) return;
        work();
        last_ = start;
        cost_ = secondsSince(start);
    }

  private:
    double period_, share_;
    double cost_ = 0;  ///< s, the last time
    Instant::time_point last_{};
};

}  // namespace sunder::view
