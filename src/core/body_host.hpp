#pragma once
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

/// A solver that can advance some bodies of its world and leave the others to another solver. At
/// first it holds them all; Solver::state() says nothing about those it does not hold. Objects go
/// with any body that does; a solver without bodies leaves them alone.
class BodyHost {
  public:
    virtual ~BodyHost() = default;
    /// Takes over bodies, with their parts of `state`, to the bit; those that it holds already go
    /// on from there. They are awake, others are left as they are. `bodies` ascend; `state.step`
    /// must be this solver's step.
    virtual void adopt(const std::vector<int>& bodies, const State& state) = 0;
    /// Puts bodies that it holds into their parts of `state`, to the bit, and no longer advances
    /// them. Waits for the GPU.
    virtual void release(const std::vector<int>& bodies, State& state) = 0;
    virtual bool holds(int body) const = 0;
};

}  // namespace sunder::core
