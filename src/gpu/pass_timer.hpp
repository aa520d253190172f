#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "gl/timer.hpp"

namespace sunder::gpu {

/// Measures a solver's passes by name. Give it to GpuSolver::setPassTimer() for as long as times
/// are wanted.
///
/// On hardware by timer queries, which do not hold up anything. A driver in software computes
/// vertices while it takes the command, where its queries do not look (llvmpipe: 30 ns for any
/// transform feedback); there each pass is waited for and the clock is read.
class PassTimer {
  public:
    struct Times {
        std::string pass;
        std::vector<double> milliseconds;  ///< one entry per run of the pass
    };
    explicit PassTimer(bool softwareDriver) : software_(softwareDriver) {}
    void begin(const char* pass);
    void end();
    /// Passes in the order they first ran. Waits for the GPU; forgets what it returns.
    std::vector<Times> take();

  private:
    struct Entry {
        std::string pass;
        gl::Timer timer;
        std::vector<double> clocked;  ///< ms
    };
    std::vector<Entry> entries_;
    Entry* running_ = nullptr;
    bool software_;
    std::chrono::steady_clock::time_point start_;
};

/// Tells the timer, if there is one, that a pass runs while this lives. Passes do not nest.
class TimedPass {
  public:
    TimedPass(PassTimer* timer, const char* pass) : timer_(timer) {
        if (timer_) timer_->begin(pass);
    }
    ~TimedPass() {
        if (timer_) timer_->end();
    }
    TimedPass(const TimedPass&) = delete;
    TimedPass& operator=(const TimedPass&) = delete;

  private:
    PassTimer* timer_;
};

}  // namespace sunder::gpu
