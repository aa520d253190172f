#pragma once
#include <cstdint>
#include <vector>

#include "core/incident.hpp"

namespace sunder::app {

/// What became of a run's incidents.
struct IncidentTally {
    static constexpr std::size_t kStrongest = 10;
    std::int64_t contacts = 0, breaks = 0, dropped = 0;
    std::size_t capacity = 0;               ///< of the ring they came through
    std::vector<core::Incident> strongest;  ///< at most kStrongest, by impulse

    /// Takes what has come into the ring.
    void take(core::IncidentRing& ring);
};

}  // namespace sunder::app
