#pragma once
#include <cstdint>
#include <vector>

namespace sunder::balance {

/// Shares bodies out between CPU and GPU (thesis, chapter 9: "load balancing"). It tries shares and
/// keeps the one whose frames took least time: nothing at all on the GPU, everything, the share at
/// which both would be done together if nothing else cost time, then neighbours of the best until
/// none is better. What a share costs is only ever measured as a whole, so that drivers which
/// compute on the CPU, submission and memory traffic count as they are. It looks around again when
/// the load changes and now and then, and starts over when the load doubles or halves.
///
/// Knows nothing of solvers or clocks: advice, a measurement, the next advice.
class LoadBalancer {
  public:
    /// cells: of every body.
    explicit LoadBalancer(std::vector<int> cells);

    /// Whether body `i` belongs on the GPU. Valid until the next call of frame().
    bool onGpu(int body) const { return onGpu_[body]; }
    /// Begins a frame: says which bodies cost anything, and moves bodies by what is known so far.
    /// Sleeping bodies stay where they are. Returns whether the frame is to be measured.
    bool frame(const std::vector<bool>& awake);
    /// How long the frame took on both sides together, in any unit that does not change.
    void measured(double time);
    /// Whether it has found its share: frames are no longer measured.
    bool settled() const { return load_ > 0 && !trying_; }
    /// Share of the awake cells that it wants on the GPU, 0 to 1.
    double share() const { return share_; }

  private:
    struct Trial {
        double share;
        double time;
    };
    void begin(std::vector<double> shares);
    void nextTrial();
    void addTrials();
    const Trial& best() const;
    void place(const std::vector<bool>& awake);

    std::vector<int> cells_;
    std::vector<std::size_t> largestFirst_;  ///< bodies
    std::vector<bool> onGpu_;
    double share_ = 0;
    std::vector<double> untried_;  ///< shares, last one first
    std::vector<Trial> tried_;
    int frames_ = 0;      ///< of this trial, or since the last one
    int lastGain_ = 0;    ///< frame of this trial that was faster than those before
    double fastest_ = 0;  ///< frame of this trial
    bool trying_ = false;
    bool fromScratch_ = false;  ///< the trials began with nothing and everything on the GPU
    std::int64_t load_ = 0;     ///< awake cells when they began
};

}  // namespace sunder::balance
