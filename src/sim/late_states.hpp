#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include "core/solver.hpp"

namespace sunder::sim {

/// States that the CPU looks at in every frame without waiting for a GPU: they are copied as frames
/// are given to it, and looked at kLateness frames later. Which frame is looked at depends on the
/// calls alone, not on how fast the GPU is, so a run repeats itself to the bit.
class LateStates {
  public:
    static constexpr int kLateness = 2;   ///< frames
    static constexpr int kPatience = 60;  ///< frames that are copied without anybody looking

    /// That solver from now on; it must live until the next one is set. waits: whether its state()
    /// waits for a GPU. Copies take memory there once somebody looks.
    void setSolver(const core::Solver& solver, bool waits);
    /// What was copied before is of no use: a body has come or gone, or the state was set.
    void forget();
    /// Whether the state itself may be looked at without waiting.
    bool present() const { return finished_ || !waits_; }
    /// Nothing is left for the GPU to do.
    void finished() { finished_ = true; }
    /// The solver has advanced by a frame.
    void advanced();
    /// Precondition: not present(). Waits where nobody has looked for a while, or after forget().
    const core::State& look();

  private:
    struct Copy {
        std::unique_ptr<core::StateCopy> state;  ///< null: not made yet
        std::int64_t frame = -1;                 ///< −1: none
    };
    Copy& copyOf(std::int64_t frame) { return copies_[static_cast<std::size_t>(frame % kCopies)]; }
    static constexpr int kCopies = kLateness + 1;

    const core::Solver* solver_ = nullptr;
    bool waits_ = false;  ///< the solver's state() would
    bool finished_ = true;
    std::array<Copy, kCopies> copies_;
    std::int64_t frame_ = 0;
    std::int64_t looked_ = -kPatience - 1;  ///< when somebody did
    core::State seen_;
    std::int64_t seenFrame_ = -1;  ///< −1: none
};

}  // namespace sunder::sim
