#pragma once

namespace sunder::files {

/// While one lives, SIGINT, SIGTERM and, where there is one, SIGHUP do not end the program: they
/// are noted, and loops look at that between two frames. Once none lives, the first one noted does
/// what it would have done, unless it was answered. A signal that the program was started to ignore
/// is ignored still. They nest, on any thread.
class HeldSignals {
  public:
    HeldSignals();
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    /// What has been noted so far is seen to: the program ends of itself.
    void answer();
};

/// The first signal that was noted, or 0.
int notedSignal();
/// For what takes time once a signal was noted: whether another one has come since this was first
/// asked, so that it is to be given up. All that came before are one wish.
bool signalledAgain();
/// As shells have it: 130 for SIGINT, 143 for SIGTERM.
constexpr int exitCodeOf(int signal) {
    return 128 + signal;
}

}  // namespace sunder::files
