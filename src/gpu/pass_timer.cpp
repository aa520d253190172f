#include "gpu/pass_timer.hpp"

#include <algorithm>
#include <cassert>

namespace sunder::gpu {

void PassTimer::begin(const char* pass) {
    assert(!running_);
    auto entry = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& known) { return known.pass == pass; });
    if (entry == entries_.end()) entry = entries_.insert(entry, Entry{pass, {}});
    running_ = &entry->timer;
    running_->begin();
}

void PassTimer::end() {
    assert(running_);
    running_->end();
    running_ = nullptr;
}

std::vector<PassTimer::Times> PassTimer::take() {
    std::vector<Times> times;
    for (Entry& entry : entries_) times.push_back({entry.pass, entry.timer.take()});
    return times;
}

}  // namespace sunder::gpu
