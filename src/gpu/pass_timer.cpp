#include "gpu/pass_timer.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace sunder::gpu {

void PassTimer::begin(const char* pass) {
    assert(!running_);
    auto entry = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& known) { return known.pass == pass; });
    if (entry == entries_.end()) entry = entries_.insert(entry, Entry{pass, {}, {}});
    running_ = &*entry;
    if (software_) {
        glFinish();
        start_ = std::chrono::steady_clock::now();
    } else {
        running_->timer.begin();
    }
}

void PassTimer::end() {
    assert(running_);
    if (software_) {
        glFinish();
        const auto elapsed = std::chrono::steady_clock::now() - start_;
        running_->clocked.push_back(std::chrono::duration<double, std::milli>(elapsed).count());
    } else {
        running_->timer.end();
    }
    running_ = nullptr;
}

std::vector<PassTimer::Times> PassTimer::take() {
    std::vector<Times> times;
    for (Entry& entry : entries_)
        times.push_back(
            {entry.pass, software_ ? std::exchange(entry.clocked, {}) : entry.timer.take()});
    return times;
}

}  // namespace sunder::gpu
