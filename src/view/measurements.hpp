#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"
#include "gpu/pass_timer.hpp"

namespace sunder::view {

/// The last values of something, one per frame.
class History {
  public:
    static constexpr int kLength = 240;
    void add(double value);
    const float* values() const { return values_.data(); }
    int next() const { return next_; }  ///< index of the oldest
    double mean(int count) const;       ///< of the newest
    double largest() const;

  private:
    std::array<float, kLength> values_{};
    int next_ = 0, filled_ = 0;
};

/// What frames cost, and what the simulation has come to.
struct Measurements {
    History frame, simulation, drawing, interface;        ///< ms
    std::vector<std::pair<std::string, History>> passes;  ///< ms in a frame, of a GPU's passes
    core::Diagnostics diagnostics;
    int breaks = 0, contacts = 0;  ///< incidents since the start

    double framesPerSecond() const;
    /// Of a frame.
    void addPasses(const std::vector<gpu::PassTimer::Times>&);
};

}  // namespace sunder::view
