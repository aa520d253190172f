#pragma once
#include <string_view>

#include "core/world.hpp"

namespace sunder {

class IncidentRing;

/// Advances a world in time. Every solver means the same physics (shared contract: README,
/// "Solvers").
class Solver {
  public:
    virtual ~Solver() = default;
    virtual std::string_view name() const = 0;
    /// Advances by this many substeps. May return before a GPU is done.
    virtual void advance(int steps) = 0;
    /// Returns once everything that advance() started is done.
    virtual void finish() {}
    virtual State state() const = 0;
    /// `state` must come from the same world.
    virtual void setState(const State& state) = 0;
    /// Whether a body is at rest and costs nothing (core/sleep.hpp); solvers may never let one.
    virtual bool asleep([[maybe_unused]] int body) const { return false; }
    /// From now on incidents go there; null: nowhere, the default, at no cost. The state does not
    /// depend on it. Solvers on a GPU hand them over two looks late, all in finish(). The ring
    /// must outlive its use here.
    virtual void setIncidents(IncidentRing* ring) = 0;
};

}  // namespace sunder
