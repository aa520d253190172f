#include "app/incident_tally.hpp"

#include <algorithm>

namespace sunder::app {

using namespace core;

void IncidentTally::take(IncidentRing& ring) {
    for (const Incident& incident : ring.take()) {
        ++(incident.kind == Incident::Kind::Break ? breaks : contacts);
        strongest.push_back(incident);
    }
    std::stable_sort(strongest.begin(), strongest.end(),
                     [](const Incident& a, const Incident& b) { return a.impulse > b.impulse; });
    if (strongest.size() > kStrongest) strongest.resize(kStrongest);
    dropped = ring.dropped();
    capacity = ring.capacity();
}

}  // namespace sunder::app
