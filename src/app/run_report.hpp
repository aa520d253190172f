#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/incident_tally.hpp"
#include "core/diagnostics.hpp"
#include "core/sunk.hpp"
#include "scene/scene.hpp"

namespace sunder::app {

/// What `sunder run` found out, beyond the scene and its last state.
struct RunFacts {
    std::string solver;
    std::string renderer;  ///< GL_RENDERER, or empty without a context
    int frames = 0;
    int stepsPerFrame = 0;
    std::optional<int> bodiesOnGpu;  ///< at the end, of a solver that shares them out
    std::vector<double> msPerStep;   ///< one entry per frame
    IncidentTally incidents;
    struct {
        std::int64_t contacts = 0;     ///< Solver::droppedContacts()
        std::vector<double> haste;     ///< Solver::contactHaste()
        std::vector<core::Sunk> sunk;  ///< at the end
    } losses;                          ///< what the solver had to leave out
};

/// The contents of --json.
std::string reportJson(const scene::Scene&, const core::World&, const core::State&,
                       const RunFacts&);
/// A few lines for a person.
std::string reportText(const scene::Scene&, const core::World&, const core::State&,
                       const RunFacts&);

}  // namespace sunder::app
