#include "support/peak_memory.hpp"

#include <fstream>
#include <string>

namespace {

/// kB of a line of Linux's /proc/self/status.
std::int64_t statusOf(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word != key + ":") continue;
        std::int64_t value = 0;
        status >> value;
        return value;
    }
    return 0;
}

}  // namespace

std::int64_t peakMemory(const std::function<void()>& work) {
    std::ofstream("/proc/self/clear_refs") << 5;  // the peak is what there is now
    const std::int64_t before = statusOf("VmRSS");
    work();
    return before > 0 ? 1024 * (statusOf("VmHWM") - before) : 0;
}
