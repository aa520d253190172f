#include "app/incident_tally.hpp"

#include <algorithm>

namespace sunder::app {

using namespace core;

void IncidentTally::take(sim::Simulation& simulation) {
    for (const Incident& incident : simulation.takeIncidents()) {
        ++(incident.kind == Incident::Kind::Break ? breaks : contacts);
        strongest.push_back(incident);
    }
    std::stable_sort(strongest.begin(), strongest.end(),
                     [](const Incident& a, const Incident& b) { return a.impulse > b.impulse; });
    if (strongest.size() > kStrongest) strongest.resize(kStrongest);
    dropped = simulation.droppedIncidents();
    capacity = simulation.incidentRoom();
}

}  // namespace sunder::app
