#pragma once
#include "core/world.hpp"

namespace sunder {

/// A solver that can advance some bodies of its world and leave the others to another solver. At
/// first it holds them all; Solver::state() says nothing about those it does not hold.
class BodyHost {
  public:
    virtual ~BodyHost() = default;
    /// Takes over a body that it does not hold, with its part of `state`, to the bit. The body is
    /// awake. `state.step` must be this solver's step.
    virtual void adopt(int body, const State& state) = 0;
    /// Puts a body that it holds into its part of `state`, to the bit, and no longer advances it.
    /// Waits for the GPU.
    virtual void release(int body, State& state) = 0;
    virtual bool holds(int body) const = 0;
};

}  // namespace sunder
