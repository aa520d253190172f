#pragma once
#include <deque>

namespace sunder::view {

/// Says how many substeps a frame has to simulate so that time in the window runs as time outside
/// does, or slower, or not at all. Where the machine cannot keep up, time is dropped: what a frame
/// simulates has a limit, so a slow frame never asks the next one for more work than it had itself.
class Clock {
  public:
    /// `step`: s of simulated time, one substep.
    explicit Clock(double step) : step_(step) {}

    double step() const { return step_; }
    void setStep(double step);

    bool paused() const { return paused_; }
    void pause(bool paused) { paused_ = paused; }
    /// Simulated seconds per second, kSlowest to 1.
    double speed() const { return speed_; }
    void setSpeed(double speed);
    static constexpr double kSlowest = 1.0 / 64;

    /// While paused: the next frame simulates so many substeps.
    void stepOnce(int steps) { once_ += steps; }
    /// Each frame simulates 1/60 s times speed() from now on, however long it takes: for a video.
    void setFixed(bool fixed);
    /// The frame that is going on does not count: what it did, such as building a wall, is not what
    /// frames are for, and its length is not made up for.
    void skip() { skip_ = true; }

    /// Substeps for a frame that begins `elapsed` s after the last one did.
    int tick(double elapsed);
    /// How long those took, s.
    void took(int steps, double seconds);

    /// Simulated time over what was wanted in the last second or so, 0 to 1; 1 while paused.
    double share() const;
    /// Whether time is being dropped, enough to be worth a word.
    bool behind() const { return share() < 0.95; }
    /// s of simulated time left out so far.
    double dropped() const { return dropped_; }

    /// A frame simulates no more than this, s of simulated time …
    static constexpr double kMostTime = 0.25;
    /// … and no more than takes about this long, s, or as long as the rest of the frame: where
    /// drawing is slow, simulating may be, too. Once a frame took longer the limit sinks at once,
    /// and rises again from frame to frame.
    static constexpr double kMostWork = 0.04;

  private:
    struct Frame {
        double elapsed, wanted, simulated;  ///< s
    };
    double step_, speed_ = 1;
    bool paused_ = false, fixed_ = false, skip_ = false;
    int once_ = 0;
    double owed_ = 0, dropped_ = 0;  ///< s of simulated time
    double budget_ = kMostWork;      ///< s of work for this frame
    double most_ = 0;                ///< substeps in a frame; 0: not known yet
    std::deque<Frame> recent_;       ///< about a second
};

}  // namespace sunder::view
