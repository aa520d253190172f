#include "files/held_signals.hpp"

#include <atomic>
#include <csignal>
#include <iterator>
#include <mutex>

namespace sunder::files {
namespace {

constexpr int kSignals[] = {
    SIGINT,
    SIGTERM,
#ifdef SIGHUP
    SIGHUP,
#endif
};

using Handler = void (*)(int);

std::mutex holders;
int holderCount = 0;
Handler before[std::size(kSignals)];
std::atomic<int> first = 0, count = 0, heeded = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void noteSignal(int signal) {
#ifdef _WIN32
    std::signal(signal, noteSignal);  // forgotten when it is called
#endif
    int none = 0;
    first.compare_exchange_strong(none, signal);
    ++count;
}

void forget() {
    first = count = heeded = 0;
}

/// Returns the signal that is still to do its work, or 0.
int letGo() {
    const std::lock_guard lock(holders);
    if (--holderCount > 0) return 0;
    for (std::size_t i = 0; i < std::size(kSignals); ++i)
        if (before[i] != SIG_ERR) std::signal(kSignals[i], before[i]);
    const int noted = first;
    forget();
    return noted;
}

}  // namespace

HeldSignals::HeldSignals() {
    const std::lock_guard lock(holders);
    if (holderCount++ > 0) return;
    for (std::size_t i = 0; i < std::size(kSignals); ++i) {
        before[i] = std::signal(kSignals[i], noteSignal);
        if (before[i] == SIG_IGN) std::signal(kSignals[i], SIG_IGN);
    }
}

HeldSignals::~HeldSignals() {
    if (const int noted = letGo()) std::raise(noted);
}

void HeldSignals::answer() {
    forget();
}

int notedSignal() {
    return first;
}

bool signalledAgain() {
    const int now = count;
    int none = 0;
    heeded.compare_exchange_strong(none, now);
    return now > heeded;
}

}  // namespace sunder::files
