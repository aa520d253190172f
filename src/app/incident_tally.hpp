#pragma once
#include <cstdint>
#include <vector>

#include "core/incident.hpp"
#include "sim/simulation.hpp"

namespace sunder::app {

/// What became of a run's incidents.
struct IncidentTally {
    static constexpr std::size_t kStrongest = 10;
    std::int64_t contacts = 0, breaks = 0, dropped = 0;
    std::size_t capacity = 0;               ///< how many the simulation had room for
    std::vector<core::Incident> strongest;  ///< at most kStrongest, by impulse

    /// Takes what the simulation has found.
    void take(sim::Simulation&);
};

}  // namespace sunder::app
