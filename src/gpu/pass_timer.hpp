#pragma once
#include <string>
#include <vector>

#include "gl/timer.hpp"

namespace sunder::gpu {

/// Measures a solver's passes by name. Give it to GpuSolver::setPassTimer() for as long as times
/// are wanted.
class PassTimer {
  public:
    struct Times {
        std::string pass;
        std::vector<double> milliseconds;  ///< one entry per run of the pass
    };
    void begin(const char* pass);
    void end();
    /// Passes in the order they first ran. Waits for the GPU; forgets what it returns.
    std::vector<Times> take();

  private:
    struct Entry {
        std::string pass;
        gl::Timer timer;
    };
    std::vector<Entry> entries_;
    gl::Timer* running_ = nullptr;
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
